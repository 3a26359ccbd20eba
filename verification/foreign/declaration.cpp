// The file that declares another code's result.
#include "verification/foreign/foreign_result.h"
#include "verification/scene/complaints.h"
#include "verification/scene/document.h"
#include "verification/scene/read.h"
#include "verification/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace wetfront::verification {
namespace {

/// What a code calls a field, in which unit and with which sign, where it is always the same.
struct Habit {
  std::string array, unit, positive;
};
struct KnownCode {
  const char *name, *begins;  ///< `begins`: of its name in small letters, without hyphens
  Habit pressure, saturation;
};
/// Anura3D: read off its own output (cases/foreign_infiltration): kN, m, s, stresses and pressures tension-positive.
/// CB-Geo mpm writes the equation of state's pressure, compression-positive, in the unit of its input, which its
/// examples give in SI; it has one such pressure and no saturation of that name.
const KnownCode known_codes[] = {
    {"Anura3D", "anura3d", {"pressure_liquid", "kPa", "tension"}, {"degree_saturation_liquid", "1", ""}},
    {"CB-Geo", "cbgeo", {"pressure", "Pa", "compression"}, {}}};

const KnownCode* known_code(const std::string& code) {
  std::string plain;
  for (const unsigned char c : code)
    if (c != '-' && c != ' ') plain += static_cast<char>(std::tolower(c));
  const auto found =
      std::ranges::find_if(known_codes, [&](const KnownCode& one) { return plain.starts_with(one.begins); });
  return found == std::end(known_codes) ? nullptr : found;
}

/// Reads the declaration's tables and complains as scenes do.
class Declaration {
 public:
  Declaration(const Value& root, const std::filesystem::path& path)
      : root_(root), path_(path), complaints_(path.string()) {}

  ForeignResult read() {
    known(root_, {"title", "code", "snapshot", "columns", "pressure", "saturation"}, "the declaration");
    out_.path = path_;
    out_.title = text(root_, "title", {1, 1});
    out_.code = text(root_, "code", {1, 1});
    code_ = known_code(out_.code);
    snapshots();
    columns();
    out_.pressure = field("pressure", code_ ? code_->pressure : Habit{}, "Pa");
    out_.saturation = field("saturation", code_ ? code_->saturation : Habit{}, "1");
    if (complaints_.any()) throw SceneError(complaints_.in_order());
    std::ranges::sort(out_.snapshots, {}, &ForeignSnapshot::time);
    return std::move(out_);
  }

 private:
  void snapshots() {
    const Entry* snapshots = root_.find("snapshot");
    if (!snapshots || snapshots->value.items.empty())
      complaints_.add({1, 1},
                      {"there is no [[snapshot]]", "nothing would be compared", "Add one with file = and time =."});
    else
      for (const Value& one : snapshots->value.items) {
        known(one, {"file", "time"}, "[[snapshot]]");
        out_.snapshots.push_back({path_.parent_path() / text(one, "file", one.place), quantity(one, "time", "s")});
      }
  }
  /// What tables call the places, in which unit, and, if wanted, what is compared.
  void columns() {
    const Entry* entry = root_.find("columns");
    if (!entry) return;
    const Value& table = entry->value;
    known(table, {"x", "y", "z", "unit", "pressure", "saturation"}, "[columns]");
    const char* axes[] = {"x", "y", "z"};
    for (std::size_t a = 0; a < 3; ++a)
      if (table.find(axes[a])) out_.places[a] = text(table, axes[a], table.place);
    if (table.find("unit")) out_.metres = unit_of(table, text(table, "unit", table.place), "m");
  }
  void known(const Value& table, const std::vector<std::string>& keys, const std::string& where) {
    for (const Entry& entry : table.entries)
      if (std::ranges::find(keys, entry.key) == keys.end())
        complaints_.add(entry.place, {"unknown key '" + entry.key + "' in " + where,
                                      "a key that nothing reads would change nothing; known are " + alternatives(keys),
                                      suggest(entry.key, keys)});
  }
  std::string text(const Value& table, const std::string& key, Place place) {
    const Entry* entry = table.find(key);
    if (entry && entry->value.kind == Value::Kind::text) return entry->value.text;
    complaints_.add(entry ? entry->place : place,
                    {key + " is missing or is no text", "it is needed", "Write " + key + " = \"...\"."});
    return "";
  }
  double quantity(const Value& table, const std::string& key, const std::string& unit) {
    const std::string written = text(table, key, table.place);
    if (written.empty()) return 0;
    const auto value = read_quantity(written, unit);
    if (const auto* complaint = std::get_if<Complaint>(&value)) {
      complaints_.add(table.find(key)->value.place, *complaint);
      return 0;
    }
    return std::get<double>(value);
  }
  /// One `written` in `unit`.
  double unit_of(const Value& table, const std::string& written, const std::string& unit) {
    const auto value = read_quantity("1 " + written, unit);
    if (const auto* complaint = std::get_if<Complaint>(&value)) {
      complaints_.add(table.place, *complaint);
      return 1;
    }
    return std::get<double>(value);
  }
  /// A key of a field's table, or what the code is known for, which is noted.
  std::string said_or_known(const Value& table, const std::string& name, const std::string& key,
                            const std::string& habit) {
    if (table.find(key) || habit.empty()) return text(table, key, table.place);
    out_.assumed.push_back(fmt::format("assumed, as {} has it: [{}] {} = \"{}\"", code_->name, name, key, habit));
    return habit;
  }
  /// The field's array: in its own table or among the columns.
  std::string array_of(const Value& table, const std::string& name, const std::string& habit) {
    const Entry* columns = root_.find("columns");
    const bool column = columns && columns->value.find(name);
    if (!column) return said_or_known(table, name, "array", habit);
    if (const Entry* twice = table.find("array"))
      complaints_.add(twice->place, {name + " is named twice", "[columns] names it, too", "Leave one of them out."});
    return text(columns->value, name, columns->value.place);
  }
  ForeignField field(const std::string& name, const Habit& habit, const std::string& unit) {
    static const Value nothing;
    const Entry *entry = root_.find(name), *columns = root_.find("columns");
    const bool named = !habit.array.empty() || (columns && columns->value.find(name));
    if (!entry && !named) {
      complaints_.add({1, 1}, {"there is no [" + name + "]", "both pressure and saturation are compared",
                               "Add it with array = ..."});
      return {};
    }
    const Value& table = entry ? entry->value : nothing;
    const bool pressure = unit == "Pa";
    known(table,
          pressure ? std::vector<std::string>{"array", "unit", "positive"} : std::vector<std::string>{"array", "unit"},
          "[" + name + "]");
    ForeignField out{array_of(table, name, habit.array)};
    if (pressure || table.find("unit"))
      if (const std::string written = said_or_known(table, name, "unit", habit.unit); !written.empty())
        out.factor = unit_of(table, written, unit);
    if (!pressure) return out;
    const std::string sign = said_or_known(table, name, "positive", habit.positive);
    if (sign == "tension" || sign == "suction")
      out.factor = -out.factor;
    else if (sign != "compression" && !sign.empty())
      complaints_.add(table.place,
                      {"positive = \"" + sign + "\" is no sign", "a pressure is positive in compression or in tension",
                       "Write positive = \"compression\" or \"tension\"."});
    return out;
  }

  const Value& root_;
  std::filesystem::path path_;
  Complaints complaints_;
  const KnownCode* code_ = nullptr;
  ForeignResult out_;
};

}  // namespace

ForeignResult read_foreign(const std::filesystem::path& path) {
  const std::string text = scene_file_text(path);
  ForeignResult result = Declaration(parse_document(text, path.string()), path).read();
  result.text = text;
  return result;
}

}  // namespace wetfront::verification
