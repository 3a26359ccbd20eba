#include "verification/scene/csv_table.h"
#include "verification/scene/former_fields.h"
#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

HydrostaticStart read_hydrostatic(SectionReader& table, double water_table) {
  const double cap = table.quantity("suction_cap");
  return {water_table, table.has("suction_cap") ? cap : std::numeric_limits<double>::infinity()};
}

ProfileStart read_profile_start(SectionReader& section, const Reading& reading) {
  Rows rows = read_pairs(section, "profile", reading.folder());
  check_ascending(rows, 0, false, "the elevations");
  return rows.size() == 0 ? ProfileStart{{0}, {std::nan("")}} : ProfileStart{rows.column[0], rows.column[1]};
}

SoilStart read_by_soil(SectionReader& section, const Reading& reading) {
  SoilStart start;
  const Value* list = section.raw("by_soil");
  const bool sound =
      list->kind == Value::Kind::array && !list->items.empty() &&
      std::all_of(list->items.begin(), list->items.end(), [](const Value& pair) {
        return pair.kind == Value::Kind::array && pair.items.size() == 2 && pair.items[0].kind == Value::Kind::text;
      });
  if (!sound) {
    section.complain("by_soil", {section.shown("by_soil") + " is not a list of [soil, pressure]",
                                 "each soil has a pore pressure", "Write " + assignment(section.key("by_soil"))});
    return start;
  }
  std::vector<std::string> names;
  for (const Soil& soil : reading.scene.soils) names.push_back(soil.name);
  for (const Value& pair : list->items) {
    const std::string name = pair.items[0].text;
    if (std::find(names.begin(), names.end(), name) == names.end())
      section.complain_at(pair.items[0].place, {"there is no soil '" + name + "'",
                                                "the scene has " + alternatives(names), suggest(name, names)});
    start.pressure.emplace_back(name, section.item_in_range("by_soil", pair.items[1]));
  }
  for (const std::string& name : names)
    if (std::none_of(start.pressure.begin(), start.pressure.end(),
                     [&](const auto& pair) { return pair.first == name; }))
      section.complain("by_soil", {"the soil '" + name + "' has no pressure in by_soil", "its start would be unknown",
                                   "Add [\"" + name + "\", \"-10 kPa\"]."});
  return start;
}

SpinUpStart read_spin_up(SectionReader& table, Reading& reading) {
  SpinUpStart start;
  if (table.has("series")) start.rain = read_series(table);
  if (const std::string file = table.text("csv"); !file.empty())
    start.rain = read_rain_csv(reading.folder() / file, table.place_of("csv"), reading.complaints);
  start.duration = table.quantity("duration");
  start.from = read_hydrostatic(table, table.quantity("water_table"));
  if (!start.rain.start.empty() && start.rain.start.back() >= start.duration)
    table.complain("duration", {table.shown("duration") + " ends before the record does",
                                fmt::format("its last row is at {:g} s", start.rain.start.back()),
                                "The end of the spin-up is the start of the run: let it last longer."});
  return start;
}

/// The field file of a former run: `reference_grid_NNNN.vtu` of fields/, told by the times in reference_grid.pvd.
std::filesystem::path field_of_run(SectionReader& table, const Reading& reading) {
  const std::filesystem::path fields = reading.folder() / table.text("folder") / "fields";
  const double time = table.quantity("time");
  const FormerFields former = former_fields(fields / "reference_grid.pvd");
  if (former.file.empty()) {
    table.complain("folder", {table.shown("folder") + " holds no fields of a reference",
                              "there is no " + (fields / "reference_grid.pvd").string(),
                              "Run `wetfront reference` of that scene, with [comparison] times, and name its folder."});
    return {};
  }
  if (!table.has("time")) return fields / former.file.back();
  std::string times;
  for (std::size_t i = 0; i < former.file.size(); ++i) {
    if (std::abs(former.time[i] - time) <= 1e-6 * std::max(1.0, time)) return fields / former.file[i];
    times += fmt::format("{}{:g} s", i == 0 ? "" : ", ", former.time[i]);
  }
  table.complain("time", {table.shown("time") + " is not among that run's fields", "it has " + times,
                          "Write one of those, or leave time out for the last."});
  return {};
}

FieldStart read_vtu(SectionReader& section, const std::string& key, const std::filesystem::path& file) {
  FieldStart start;
  start.file = file;
  std::error_code error;
  if (!file.empty() && !std::filesystem::is_regular_file(file, error))
    section.complain(key, {section.shown(key) + " cannot be read", "there is no file " + file.string(),
                           "The path is relative to the scene's folder."});
  return start;
}

CsvForm form_of_places(const TableColumn& value, int dim) {
  const TableColumn x{"x", "m"}, y{"y", "m"}, z{"z", "m"};
  CsvForm form{"file", {{x, y, value}}, "0, 0, 1"};
  if (dim == 3) form.headers = {{x, y, z, value}};
  if (dim == 0) form.headers.push_back({x, y, z, value});
  return form;
}

PlaceTable places_of(const CsvTable& table) {
  PlaceTable places;
  places.value = table.column.back();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::array<double, 3> place{};
    for (std::size_t axis = 0; axis + 1 < table.column.size(); ++axis) place[axis] = table.column[axis][i];
    places.place.push_back(place);
  }
  places.bilinear = forms_grid(places.place);
  return places;
}

/// Pressures over elevation or at places.
void read_points(SectionReader& section, const std::string& file, const Reading& reading, InitialState& state) {
  const TableColumn pressure{"pressure", "Pa or m"};
  CsvForm form = form_of_places(pressure, reading.scene.geometry.dim());
  form.headers.push_back({{"elevation", "m"}, pressure});
  const CsvTable table =
      read_csv(reading.folder() / file, form, section.unit_weight(), section.place_of("csv"), section.complaints());
  if (!table.sound) return;
  if (table.column.size() > 2) {
    state.pressure = FieldStart{places_of(table), {}};
    return;
  }
  for (std::size_t i = 1; i < table.rows(); ++i)
    if (table.column[0][i] < table.column[0][i - 1])
      section.complaints().add_elsewhere(
          section.place_of("csv"), (reading.folder() / file).string(), {table.line[i], 1},
          {"the elevations do not ascend",
           fmt::format("{:g} m follows {:g} m", table.column[0][i], table.column[0][i - 1]), "Sort the rows."});
  state.pressure = ProfileStart{table.column[0], table.column[1]};
}

void need_reference(SectionReader& section, const std::string& key, const Reading& reading) {
  if (!reading.has_reference())
    section.complain(key, {key + " needs [reference]", "the reference solver computes this start", "Add [reference]."});
}

/// Why a water table cannot be a line in this scene; "" where it can.
std::string why_no_line(const Scene& scene) {
  if (std::holds_alternative<Column>(scene.geometry.shape)) return "a column has no x to follow";
  if (scene.geometry.dim() == 3 || scene.gravity[2] != 0) return "in space it would have to be a surface";
  return scene.gravity[0] != 0 ? "gravity is not along y, so x is not level" : "";
}

Polyline read_table_line(SectionReader& table, const Reading& reading) {
  if (const std::string why_not = why_no_line(reading.scene); !why_not.empty()) {
    table.complain("water_table",
                   {"the water table is a line over x", why_not, "Write one elevation: water_table = \"0 m\"."});
    return {};
  }
  Rows rows = read_pairs(table, "water_table", reading.folder());
  check_ascending(rows, 0, true, "the x of water_table");
  if (rows.size() == 1)
    rows.complain(0, {"water_table is a single point", "a line needs two",
                      "Add where it ends, or write one elevation: water_table = \"0 m\"."});
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const std::string missed = table.range_missed("water_table", rows.column[1][i]); !missed.empty())
      rows.complain(i, {"the y of water_table is out of range", "it must be " + missed,
                        "Check the sign, the unit and the exponent."});
  return rows.size() < 2 ? Polyline{} : Polyline{rows.column[0], rows.column[1]};
}

HydrostaticStart read_hydrostatic_start(SectionReader& table, const Reading& reading) {
  const bool line = takes_rows(table, "water_table");
  HydrostaticStart start = read_hydrostatic(table, line ? std::nan("") : table.quantity("water_table"));
  if (line) start.line = read_table_line(table, reading);
  start.over_base = table.choice("from") == "base";
  const Shape& shape = reading.scene.geometry.shape;
  if (start.over_base && line)
    table.complain("from", {"the water table is a line and follows the base", "a line says its elevations itself",
                            "Leave from out, or give one height above the base."});
  else if (start.over_base && !std::holds_alternative<GroundProfile>(shape) && !std::holds_alternative<Slope>(shape))
    table.complain("from", {"the water table follows the base", "only a profile and a slope have one to follow",
                            "Leave from out and give the elevation."});
  return start;
}

/// Which of the ways to say it the scene takes.
void read_state(SectionReader& section, Reading& reading, InitialState& state) {
  if (auto table = section.table("hydrostatic")) {
    state.pressure = read_hydrostatic_start(*table, reading);
    table->finish();
  }
  if (section.has("uniform")) state.pressure = UniformStart{section.quantity("uniform")};
  if (section.has("profile")) state.pressure = read_profile_start(section, reading);
  if (section.has("by_soil")) state.pressure = read_by_soil(section, reading);
  if (auto table = section.table("steady")) {
    state.pressure = SteadyStart{table->quantity("rain")};
    need_reference(section, "steady", reading);
    table->finish();
  }
  if (auto table = section.table("spin_up")) {
    state.pressure = read_spin_up(*table, reading);
    need_reference(section, "spin_up", reading);
    table->finish();
  }
  if (auto table = section.table("run")) {
    state.pressure = FieldStart{{}, field_of_run(*table, reading)};
    table->finish();
  }
  if (const std::string file = section.text("csv"); !file.empty()) read_points(section, file, reading, state);
  if (const std::string file = section.text("vtu"); !file.empty())
    state.pressure = read_vtu(section, "vtu", reading.folder() / file);
}

}  // namespace

PlaceTable read_places(const std::filesystem::path& path, const TableColumn& value, int dim, SectionReader& reader,
                       const std::string& key) {
  const CsvTable table =
      read_csv(path, form_of_places(value, dim), reader.unit_weight(), reader.place_of(key), reader.complaints());
  return table.sound ? places_of(table) : PlaceTable{};
}

void read_initial(Reading& reading) {
  auto section = reading.section("initial");
  if (!section) {
    if (reading.wet())
      reading.complaints.add({1, 1},
                             {"the scene has no [initial]", "with [water] the pore pressure at the start must be known",
                              "Add [initial] with hydrostatic = { water_table = \"0 m\" } or uniform = \"-10 kPa\"."});
    return;
  }
  if (!reading.wet()) {
    for (const Key* key : keys_of("initial"))
      section->unused(key->name, "there is no [water] in this scene", "Remove [initial], or add [water].");
    return;
  }
  InitialState state;
  state.origin = section->origin();
  read_state(*section, reading, state);
  const auto& g = reading.scene.gravity;
  const bool weightless = section->has("hydrostatic") && g[0] == 0 && g[1] == 0 && g[2] == 0;
  if (weightless)
    section->complain("hydrostatic", {"a hydrostatic start needs gravity", "gravity is zero in this scene",
                                      "Write uniform = \"0 kPa\" instead."});
  if (!weightless) reading.scene.initial = state;
  section->finish();
}

}  // namespace wetfront::verification
