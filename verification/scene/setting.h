#pragma once

#include <string>
#include <vector>

/// What is to be set anew in a scene, as one writes it on the command line.
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

/// The number at the front of a value and what follows it: {"2e-5", "m/s"}; both empty where it is no number.
struct NumberAndUnit {
  std::string number, unit;
};
NumberAndUnit number_and_unit(const std::string& value);

/// What stands between the commas that lie in no brackets: "1,[2,3]" is {"1", "[2,3]"}.
std::vector<std::string> split_at_commas(const std::string& text);

}  // namespace wetfront::verification
