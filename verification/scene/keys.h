#pragma once

#include <string>
#include <vector>

/// The one table of what a scene may say. The reader validates with it, the suggestions for misspelt keys,
/// the JSON Schema and the reference page are made from it.
namespace wetfront::verification {

enum class Takes {
  text,       ///< a non-empty string
  path,       ///< a file, relative to the scene's folder
  quantity,   ///< a number with a unit in a string; a bare number (or "25 %") when the unit is "1"
  count,      ///< a whole number
  choice,     ///< one of `choices`
  time,       ///< "1800 s" or "25 % of filling"
  times,      ///< a list of those
  tolerance,  ///< a quantity in the unit of the quantity that is gated
  vector,     ///< a list of two or three quantities
  series,     ///< a list of [time, rain intensity]
  record,     ///< a quantity; or [time, quantity] pairs, or a CSV file with them
  vectors,    ///< a list of x and y; or [time, x, y] rows, or a CSV file with them
  level,      ///< a quantity; or pairs with one quantity per column, or a CSV file with those columns
  pairs,      ///< a list of lists with one quantity per column, or a CSV file with those columns
  range,      ///< a list of two quantities, ascending
  counts,     ///< a list of two or three whole numbers
  pressures,  ///< a list of [soil name, quantity]
  table,      ///< a section of its own, named `section.name`
};

/// A column of a record, a table or a CSV file.
struct TableColumn {
  std::string name, unit;  ///< SI unit, "1", or "Pa or m"
};

enum class Presence { required, optional };

/// Bounds as the user would write them; "" for none. An open bound is itself not allowed.
struct Range {
  std::string from = {}, to = {};
  bool open_from = false, open_to = false;
};

struct Key {
  std::string section, name;
  Takes takes;
  std::string unit;  ///< SI unit of a quantity or vector; "1" for a pure number; "Pa or m" for both; else ""
  Presence presence = Presence::required;
  std::string fallback = {};  ///< of an optional key, as one would write it; "": the meaning says what absence means
  std::string meaning = {}, example = {};
  Range range = {};
  std::vector<std::string> choices = {};
  std::string with_key = {};                   ///< the key counts only with `with_key` at one of `with_choices`;
  std::vector<std::string> with_choices = {};  ///< anywhere else it is an unused value
  std::vector<TableColumn> columns = {};       ///< of a record or of pairs
};

struct Section {
  std::string name;     ///< "" for the top of the file; "soil.retention" for a table inside a section
  bool list = false;    ///< written [[name]], any number of times
  bool needed = false;  ///< a scene without it is not complete
  std::string meaning;
  std::vector<std::string> one_of;  ///< exactly one of these keys must be given
};

const std::vector<Section>& sections();
const Section& section_named(const std::string& name);

/// The parts of the table, in the order of the reference page.
std::vector<Key> ground_keys();
std::vector<Key> soil_keys();
std::vector<Key> condition_keys();
std::vector<Key> skeleton_keys();
std::vector<Key> run_keys();

/// The header line of a CSV file with these columns: `time [s], level [m]`.
std::string csv_header(const std::vector<TableColumn>& columns);

/// The keys of a section, in the order of the reference page.
std::vector<const Key*> keys_of(const std::string& section);
/// nullptr when the section has no such key.
const Key* find_key(const std::string& section, const std::string& name);

/// "at least 0 and below 1".
std::string bounds(const Range& range);

/// How a value of the key is written, ready to be pasted: `density = "1000 kg/m3"`.
std::string assignment(const Key& key);

}  // namespace wetfront::verification
