#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

meshes::RainRecord read_intensity(SectionReader& reader, Reading& reading) {
  meshes::RainRecord record;
  if (reader.has("intensity")) record = {{0.0}, {reader.quantity("intensity")}};
  if (reader.has("series")) record = read_series(reader);
  if (const std::string file = reader.text("csv"); !file.empty())
    record = read_rain_csv(reading.folder() / file, reader.place_of("csv"), reading.complaints);
  return record;
}

/// Rain and evaporation are per horizontal area: nothing of them reaches a vertical side or one from below.
void check_open_to_sky(SectionReader& reader, const Reading& reading, const std::string& side,
                       const std::string& what) {
  std::string of = side;
  for (const SidePart& part : reading.scene.geometry.parts)
    if (part.name == side) of = part.of;
  const bool built_in = !reading.sides().empty();
  if (built_in && !of.empty() && of != "top")
    reader.complain("side", {what + " on '" + side + "'", "rain is per horizontal area and comes from above",
                             "Write side = \"top\"."});
}

}  // namespace

std::string read_side(SectionReader& reader, const Reading& reading, const std::string& key) {
  const std::string side = reader.text(key);
  const std::vector<std::string> sides = reading.sides();
  if (side.empty() || sides.empty() || std::find(sides.begin(), sides.end(), side) != sides.end()) return side;
  reader.complain(
      key, {"there is no side '" + side + "'", "this geometry has " + alternatives(sides), suggest(side, sides)});
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

void read_rains(Reading& reading) {
  for (SectionReader& reader : reading.sections("rain")) {
    Rain rain{read_side(reader, reading), read_intensity(reader, reading), reader.origin()};
    if (!reading.root.find("water"))
      reading.complaints.add(reader.place(), {"rain falls, but the scene has no [water]",
                                              "nothing can fall into a dry scene", "Add [water], or remove [[rain]]."});
    check_open_to_sky(reader, reading, rain.side, "no rain can fall");
    for (const Rain& other : reading.scene.rains)
      if (other.side == rain.side && !rain.side.empty())
        reader.complain("side", {"rain falls twice on '" + rain.side + "'",
                                 "the first stands in line " + std::to_string(other.origin.line),
                                 "Keep one of the two; a series lets it vary in time."});
    reading.scene.rains.push_back(rain);
    reader.finish();
  }
}

void read_evaporation(Reading& reading) {
  for (SectionReader& reader : reading.sections("evaporation")) {
    Evaporation evaporation;
    evaporation.side = read_side(reader, reading);
    evaporation.origin = reader.origin();
    Rows rows = read_record(reader, "demand", reading.folder());
    check_ascending(rows, 0, true, "the times of the demand");
    if (rows.size() > 0) evaporation.demand = {rows.column[0], rows.column[1]};
    evaporation.least_pressure = reader.quantity("least_pressure");
    if (!reading.root.find("water"))
      reading.complaints.add(reader.place(), {"water evaporates, but the scene has no [water]",
                                              "a dry scene holds none", "Add [water], or remove [[evaporation]]."});
    check_open_to_sky(reader, reading, evaporation.side, "nothing can evaporate");
    for (const Evaporation& other : reading.scene.evaporations)
      if (other.side == evaporation.side && !evaporation.side.empty())
        reader.complain("side", {"'" + evaporation.side + "' has a second [[evaporation]]",
                                 "the first stands in line " + std::to_string(other.origin.line),
                                 "Keep one of the two; pairs let it vary in time."});
    reading.scene.evaporations.push_back(evaporation);
    reader.finish();
  }
}

}  // namespace wetfront::verification
