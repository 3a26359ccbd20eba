#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

/// What `water` prescribes: a value, or one that changes in time.
void read_prescribed(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  static const std::map<WaterCondition, std::string> keys = {{WaterCondition::pressure, "pressure"},
                                                             {WaterCondition::total_head, "head"},
                                                             {WaterCondition::water_level, "level"},
                                                             {WaterCondition::flux, "inflow"}};
  const auto key = keys.find(*boundary.water);
  if (key == keys.end()) return;
  Rows rows = read_record(reader, key->second, reading.folder());
  const bool steps = boundary.water == WaterCondition::flux;  // each holds until the next: no time twice
  check_ascending(rows, 0, steps, "the times of " + key->second);
  if (rows.size() == 0) return;
  if (steps) {
    boundary.inflow = {rows.column[0], rows.column[1]};
    boundary.least_pressure = reader.quantity("least_pressure");
    return;
  }
  boundary.record = {rows.column[0], rows.column[1]};
  if (boundary.water == WaterCondition::pressure) boundary.pressure = boundary.record.value.front();
}

void read_partner(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  if (!reader.has("partner")) return;  // said once, by check_partner
  boundary.partner = read_side(reader, reading, "partner");
  if (boundary.partner == boundary.side && !boundary.side.empty())
    reader.complain("partner", {"'" + boundary.side + "' is its own partner", "water leaves here and comes in there",
                                "Name the opposite side."});
  for (const Boundary& other : reading.scene.boundaries)
    if (other.side == boundary.partner && other.water)
      reader.complain("partner", {"'" + boundary.partner + "' has a water condition of its own",
                                  "it stands in line " + std::to_string(other.origin.line),
                                  "Say periodic once, of one of the two sides."});
}

/// Rain and evaporation on the same side: above a water level there may be rain; else they exclude another condition.
void check_weather(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  if (boundary.side.empty()) return;
  for (const Rain& rain : reading.scene.rains)
    if (rain.side == boundary.side && boundary.water != WaterCondition::water_level) {
      boundary.water.reset();
      reader.complain("water", {"'" + boundary.side + "' is given rain and a second water condition",
                                "the rain stands in line " + std::to_string(rain.origin.line),
                                "Keep one of the two; rain already lets water out where the soil is full."});
    }
  for (const Evaporation& evaporation : reading.scene.evaporations)
    if (evaporation.side == boundary.side) {
      boundary.water.reset();
      reader.complain("water", {"'" + boundary.side + "' is given evaporation and a second water condition",
                                "the evaporation stands in line " + std::to_string(evaporation.origin.line),
                                "Keep one of the two; evaporation already lets water out where the soil is full."});
    }
}

void read_water_condition(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  static const std::map<std::string, WaterCondition> known = {
      {"impermeable", WaterCondition::impermeable}, {"free-drainage", WaterCondition::free_drainage},
      {"pressure", WaterCondition::pressure},       {"seepage-face", WaterCondition::seepage_face},
      {"total-head", WaterCondition::total_head},   {"flux", WaterCondition::flux},
      {"water-level", WaterCondition::water_level}, {"as-at-start", WaterCondition::as_at_start},
      {"periodic", WaterCondition::periodic}};
  if (!reader.has("water")) return;
  if (!reading.wet()) {
    reader.unused("water", "there is no [water] in this scene", "Remove it, or add [water].");
    return;
  }
  const auto condition = known.find(reader.choice("water"));
  if (condition != known.end()) boundary.water = condition->second;
  if (boundary.water) read_prescribed(reader, boundary, reading);
  if (boundary.water == WaterCondition::periodic) read_partner(reader, boundary, reading);
  const bool flank = std::holds_alternative<Column>(reading.scene.geometry.shape) &&
                     (boundary.side == "left" || boundary.side == "right");
  if (flank && boundary.water && boundary.water != WaterCondition::impermeable && reading.has_reference())
    reader.complain("water", {"water passes through '" + boundary.side + "' of a column",
                              "the reference of a column is one-dimensional: it has only base and top",
                              "Use a slope or a mesh, or leave [reference] and its gates out."});
  if (reader.has("water")) check_weather(reader, boundary, reading);
}

/// A partner is there if and only if something is periodic.
void check_partner(SectionReader& reader, const Boundary& boundary) {
  const bool periodic = boundary.water == WaterCondition::periodic ||
                        (boundary.skeleton && boundary.skeleton->kind == SkeletonCondition::Kind::periodic);
  if (periodic && !reader.has("partner")) reader.missing("partner", reader.key("partner").meaning);
  if (!periodic && boundary.partner.empty())
    reader.unused("partner", "nothing on this side is periodic", "Remove it, or write water = \"periodic\".");
}

}  // namespace

void read_boundaries(Reading& reading) {
  for (SectionReader& reader : reading.sections("boundary")) {
    Boundary boundary;
    boundary.side = read_side(reader, reading);
    boundary.origin = reader.origin();
    const auto& before = reading.scene.boundaries;
    const auto first = std::find_if(before.begin(), before.end(), [&](const Boundary& other) {
      return other.side == boundary.side && !boundary.side.empty();
    });
    const bool repeated = first != before.end();
    if (repeated)
      reader.complain("side", {"'" + boundary.side + "' has a second [[boundary]]",
                               "the first stands in line " + std::to_string(first->origin.line),
                               "Put water and skeleton into one."});
    read_water_condition(reader, boundary, reading);
    read_skeleton_condition(reader, boundary, reading);
    check_partner(reader, boundary);
    if (!reader.has("water") && !reader.has("skeleton") && !reader.has("load") && !reader.has("traction"))
      reader.missing("water", "a boundary must say something about the water or the skeleton");
    if (!repeated) reading.scene.boundaries.push_back(boundary);
    reader.finish();
  }
}

}  // namespace wetfront::verification
