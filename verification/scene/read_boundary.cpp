#include "verification/scene/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

/// Complains of a side that the geometry does not have.
std::string read_side(SectionReader& reader, const Reading& reading) {
  const std::string side = reader.text("side");
  const std::vector<std::string> sides = reading.sides();
  if (side.empty() || sides.empty() || std::find(sides.begin(), sides.end(), side) != sides.end()) return side;
  reader.complain(
      "side", {"there is no side '" + side + "'", "this geometry has " + alternatives(sides), suggest(side, sides)});
  return "";
}

meshes::RainRecord read_series(SectionReader& reader) {
  const Value* series = reader.raw("series");
  const Complaint wrong{"series is not a list of [time, intensity] pairs",
                        "each intensity holds from its time until the next",
                        "Write series = [[\"0 s\", \"100 mm/h\"], [\"1 h\", \"0 mm/h\"]]"};
  if (series->kind != Value::Kind::array || series->items.empty()) {
    reader.complain("series", wrong);
    return {};
  }
  meshes::RainRecord record;
  for (const Value& pair : series->items) {
    if (pair.kind != Value::Kind::array || pair.items.size() != 2) {
      reader.complain("series", wrong);
      return {};
    }
    record.start.push_back(reader.item_quantity("series", pair.items[0], "s"));
    record.intensity.push_back(reader.item_quantity("series", pair.items[1], "m/s"));
  }
  for (const RainFault& fault : faults_of(record)) reader.complain_at(series->items[fault.row].place, fault.complaint);
  return record;
}

meshes::RainRecord read_record(SectionReader& reader, Reading& reading) {
  meshes::RainRecord record;
  if (reader.has("intensity")) record = {{0.0}, {reader.quantity("intensity")}};
  if (reader.has("series")) record = read_series(reader);
  if (const std::string file = reader.text("csv"); !file.empty())
    record = read_rain_csv(reading.scene.path.parent_path() / file, reader.place_of("csv"), reading.complaints);
  return record;
}

std::array<bool, 3> fixed_axes(SectionReader& reader, const std::string& side, const Scene& scene) {
  const std::string skeleton = reader.choice("skeleton");
  if (skeleton == "fixed") return {true, true, true};
  if (skeleton == "fixed-x") return {true, false, false};
  if (skeleton == "fixed-y") return {false, true, false};
  if (skeleton != "roller") return {false, false, false};
  if (side == "left" || side == "right") return {true, false, false};
  if (std::holds_alternative<Column>(scene.geometry.shape)) return {false, true, false};
  reader.complain("skeleton",
                  {"a roller on '" + side + "' is not along an axis", "the side is inclined or its direction not known",
                   "Write \"fixed\", \"fixed-x\" or \"fixed-y\"."});
  return {false, false, false};
}

void read_water_condition(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  static const std::map<std::string, WaterCondition> known = {{"impermeable", WaterCondition::impermeable},
                                                              {"free-drainage", WaterCondition::free_drainage},
                                                              {"pressure", WaterCondition::pressure},
                                                              {"seepage-face", WaterCondition::seepage_face}};
  if (!reader.has("water")) return;
  if (!reading.wet()) {
    reader.unused("water", "there is no [water] in this scene", "Remove it, or add [water].");
    return;
  }
  const auto condition = known.find(reader.choice("water"));
  if (condition != known.end()) boundary.water = condition->second;
  if (boundary.water == WaterCondition::pressure) boundary.pressure = reader.quantity("pressure");
  const bool flank = std::holds_alternative<Column>(reading.scene.geometry.shape) &&
                     (boundary.side == "left" || boundary.side == "right");
  if (flank && boundary.water && boundary.water != WaterCondition::impermeable && reading.has_reference())
    reader.complain("water", {"water passes through '" + boundary.side + "' of a column",
                              "the reference of a column is one-dimensional: it has only base and top",
                              "Use a slope or a mesh, or leave [reference] and its gates out."});
  for (const Rain& rain : reading.scene.rains)
    if (rain.side == boundary.side && !boundary.side.empty()) {
      boundary.water.reset();
      reader.complain("water", {"'" + boundary.side + "' is given rain and a second water condition",
                                "the rain stands in line " + std::to_string(rain.origin.line),
                                "Keep one of the two; rain already lets water out where the soil is full."});
    }
}

/// Why the probe is not in the soil, or "".
std::string why_outside(const Geometry& geometry, double x, double y) {
  constexpr double slack = 1e-9;  // m: a probe on the surface is inside
  const auto* column = std::get_if<Column>(&geometry.shape);
  if (column && column->height > 0) {
    const double width = column->cells > 0 ? column->height / column->cells : column->height;
    if (y < -slack || y > column->height + slack)
      return fmt::format("the column reaches from 0 m to {:g} m", column->height);
    if (x < -slack || x > width + slack) return fmt::format("the column is one cell, {:g} m, wide", width);
  }
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) {
    if (x < -slack || x > slope->length + slack)
      return fmt::format("the slope reaches from x = 0 m to {:g} m", slope->length);
    const double base = x * std::tan(slope->angle);
    if (y < base - slack || y > base + slope->thickness + slack)
      return fmt::format("at x = {:g} m the soil reaches from {:g} m to {:g} m", x, base, base + slope->thickness);
  }
  return "";
}

void read_position(SectionReader& reader, Probe& probe, const Geometry& geometry) {
  const bool column = std::holds_alternative<Column>(geometry.shape);
  std::string key = "at";
  if (reader.has("elevation")) {
    key = "elevation";
    probe.position[1] = reader.quantity("elevation");
    if (!column)
      reader.complain("elevation", {"an elevation alone does not place this probe",
                                    "only a column has one place per elevation", "Write at = [\"0 m\", \"0.6 m\"]."});
  } else {
    const std::vector<double> at = reader.vector("at");
    for (std::size_t i = 0; i < at.size(); ++i) probe.position[i] = at[i];
    check_plane(reader, "at", at, geometry);
  }
  const std::string why = why_outside(geometry, probe.position[0], probe.position[1]);
  if (!why.empty())
    reader.complain(key, {"the probe '" + probe.name + "' is outside the soil", why, "Move it into the soil."});
}

}  // namespace

void read_rains(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "rain", reading.complaints)) {
    Rain rain{read_side(reader, reading), read_record(reader, reading), reader.origin()};
    if (!reading.root.find("water"))
      reading.complaints.add(reader.place(), {"rain falls, but the scene has no [water]",
                                              "nothing can fall into a dry scene", "Add [water], or remove [[rain]]."});
    const bool built_in = !reading.sides().empty();
    if (built_in && (rain.side == "base" || rain.side == "left" || rain.side == "right"))
      reader.complain("side", {"no rain can fall on '" + rain.side + "'",
                               "rain is per horizontal area and comes from above", "Write side = \"top\"."});
    for (const Rain& other : reading.scene.rains)
      if (other.side == rain.side && !rain.side.empty())
        reader.complain("side", {"rain falls twice on '" + rain.side + "'",
                                 "the first stands in line " + std::to_string(other.origin.line),
                                 "Keep one of the two; a series lets it vary in time."});
    reading.scene.rains.push_back(rain);
    reader.finish();
  }
}

void read_boundaries(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "boundary", reading.complaints)) {
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
    if (reader.has("skeleton") && reading.elastic()) boundary.fixed = fixed_axes(reader, boundary.side, reading.scene);
    if (reader.has("skeleton") && !reading.elastic())
      reader.unused("skeleton", "every soil of this scene is rigid", "Remove it, or give the soil young and poisson.");
    if (!reader.has("water") && !reader.has("skeleton"))
      reader.missing("water", "a boundary must say something about the water or the skeleton");
    if (!repeated) reading.scene.boundaries.push_back(boundary);
    reader.finish();
  }
}

void read_probes(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "probe", reading.complaints)) {
    Probe probe;
    probe.name = reader.text("name");
    probe.origin = reader.origin();
    read_position(reader, probe, reading.scene.geometry);
    for (const Probe& other : reading.scene.probes)
      if (other.name == probe.name && !probe.name.empty())
        reader.complain("name",
                        {"a second probe is called '" + probe.name + "'",
                         "the first stands in line " + std::to_string(other.origin.line), "Give it another name."});
    reading.scene.probes.push_back(probe);
    reader.finish();
  }
}

}  // namespace wetfront::verification
