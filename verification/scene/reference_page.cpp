#include "verification/scene/complaints.h"
#include "verification/scene/keys.h"
#include "verification/scene/quantities.h"
#include "verification/scene/read.h"
#include "verification/scene/units.h"

namespace wetfront::verification {
namespace {

std::string row_of(const Key& key) {
  std::string names;
  for (const TableColumn& column : key.columns) names += (names.empty() ? "" : ", ") + column.name;
  return '[' + names + ']';
}

std::string takes(const Key& key) {
  switch (key.takes) {
    case Takes::text:
      return "text";
    case Takes::path:
      return "file, relative to the scene";
    case Takes::quantity:
      return dimension(key.unit);
    case Takes::tolerance:
      return "quantity in the unit of what is gated";
    case Takes::count:
      return "whole number";
    case Takes::choice:
      return key.choices.size() > 12 ? "one of the quantities below" : alternatives(key.choices);
    case Takes::time:
      return "time";
    case Takes::times:
      return "list of times";
    case Takes::vector:
      return "list of two or three, each " + dimension(key.unit);
    case Takes::series:
      return "list of [time, rain intensity]";
    case Takes::record:
    case Takes::level:
      return dimension(key.unit) + "; or a list of " + row_of(key) + "; or a CSV file `" + csv_header(key.columns) +
             "`";
    case Takes::vectors:
      return "list of x and y, each " + dimension(key.unit) + "; or a list of " + row_of(key) + "; or a CSV file `" +
             csv_header(key.columns) + "`";
    case Takes::pairs:
      return "list of " + row_of(key) + ", or a CSV file `" + csv_header(key.columns) + "`";
    case Takes::range:
      return "list of two, each " + dimension(key.unit);
    case Takes::counts:
      return "list of two or three whole numbers";
    case Takes::pressures:
      return "list of [name of a soil, " + dimension(key.unit) + "]";
    case Takes::table:
      return "table, see below";
  }
  return "";
}

std::string fallback(const Key& key) {
  if (key.presence == Presence::required) return "required";
  return key.fallback.empty() ? "-" : key.fallback;
}

std::string row(const Key& key) {
  std::string meaning = key.meaning;
  if (!key.range.from.empty()) meaning += "; " + bounds(key.range);
  if (!key.with_key.empty()) meaning += "; only with " + key.with_key + " = " + alternatives(key.with_choices);
  return "| `" + key.name + "` | " + takes(key) + " | " + fallback(key) + " | " + meaning + " | `" + assignment(key) +
         "` |\n";
}

std::string heading(const Section& section) {
  if (section.name.empty()) return "## Top of the file\n\n";
  std::string text =
      "## " + std::string(section.list ? "[[" : "[") + section.name + (section.list ? "]]" : "]") + "\n\n";
  if (!section.meaning.empty())
    text += "What it is: " + section.meaning + (section.needed ? ". Required." : ".") + "\n\n";
  if (!section.one_of.empty()) text += "Exactly one of " + alternatives(section.one_of) + ".\n\n";
  return text;
}

const char* const introduction = R"(# What a scene may say

Generated from the table in `keys_*.cpp`, with which the reader also validates; do not edit. A JSON Schema made from the
same table is `scene.schema.json`.

A quantity is a number and a unit in quotation marks: `"100 mm/h"`, `"4.35 kPa"`. Units are those of udunits2, and
`deg`; capitals count. A pure number is written bare or in percent: `0.46`, `"25 %"`. A time is a quantity or relative
to the filling time (storage deficit over rain; a column over a closed base under constant rain has one):
`"25 % of filling"`. A pressure may be given as a head of water: `"-50 cm"` is `"-4.905 kPa"` with water of 1000 kg/m3.
What takes a CSV file takes its name, ending in `.csv`, in quotation marks; its header gives names and units. Nothing is ignored: unknown keys, duplicate keys and values that nothing uses are errors.

)";

const char* per(const Quantity& quantity) {
  if (quantity.per == Quantity::Per::time) return "comparison time";
  return quantity.per == Quantity::Per::run ? "run" : "probe";
}

}  // namespace

std::string scene_reference_page() {
  std::string page = introduction;
  for (const Section& section : sections()) {
    page += heading(section) + "| key | takes | default | meaning | example |\n|---|---|---|---|---|\n";
    for (const Key* key : keys_of(section.name)) page += row(*key);
    page += "\n";
  }
  page += "## Quantities that a tolerance gates\n\n| quantity | unit | one value per | meaning |\n|---|---|---|---|\n";
  for (const Quantity& quantity : quantities())
    page += "| `" + quantity.name + "` | " + (quantity.unit == "1" ? "relative" : quantity.unit) + " | " +
            per(quantity) + " | " + quantity.meaning + " |\n";
  return page;
}

}  // namespace wetfront::verification
