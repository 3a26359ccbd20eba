#pragma once

#include <string>
#include <vector>

/// One value of a scene set anew, in the text of the file: comments, order and line numbers stay.
namespace wetfront::verification {

struct Setting {
  /// Keys joined by dots. Of what may be there several times one is told by its number from 0, its name or its side:
  /// `rain.intensity` (the only rain), `soil.sand.porosity`, `soil[0].retention.lambda`, `stage[run-out].until`,
  /// `gravity[1]`.
  std::string path;
  /// As in a scene, without the quotation marks. A bare number keeps the unit that the scene writes; nothing leaves the
  /// key or the section out, or one of several: `tolerance[front_position]`.
  std::string value;
};

/// "rain.intensity=2e-5". Throws SceneError where it is none.
Setting read_setting(const std::string& text);

std::vector<Setting> read_settings(const std::vector<std::string>& texts);

/// `text` with the value in place of the one it has, or with a key or section it lacks. Whether the value makes sense
/// is the reader's to say. Throws SceneError naming `--set PATH` where the path leads nowhere, with what there is
/// instead.
std::string with_value(const std::string& text, const std::string& file, const Setting& setting);

/// The number at the front of a value and what follows it: {"2e-5", "m/s"}; both empty where it is no number.
struct NumberAndUnit {
  std::string number, unit;
};
NumberAndUnit number_and_unit(const std::string& value);

/// What stands between the commas that lie in no brackets: "1,[2,3]" is {"1", "[2,3]"}.
std::vector<std::string> split_at_commas(const std::string& text);

/// The unit of the value at a path as the scene writes it; "" for none. Throws as with_value.
std::string written_unit(const std::string& text, const std::string& path);

}  // namespace wetfront::verification
