#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

Polyline read_line(SectionReader& reader, const std::string& name, const std::filesystem::path& folder) {
  Rows rows = read_pairs(reader, name, folder);
  check_ascending(rows, 0, true, "the x of " + name);
  if (rows.size() == 1) rows.complain(0, {name + " is a single point", "a line needs two", "Add where it ends."});
  return rows.size() < 2 ? Polyline{} : Polyline{rows.column[0], rows.column[1]};
}

/// Surface over bedrock everywhere, and over the same stretch of x.
void check_profile(SectionReader& reader, const GroundProfile& profile) {
  const Polyline &surface = profile.surface, &bedrock = profile.bedrock;
  if (surface.x.empty() || bedrock.x.empty()) return;
  if (surface.x.front() != bedrock.x.front() || surface.x.back() != bedrock.x.back())
    return reader.complain("bedrock",
                           {"bedrock and surface do not end at the same x",
                            fmt::format("the surface reaches from {:g} m to {:g} m, the bedrock from {:g} m "
                                        "to {:g} m",
                                        surface.x.front(), surface.x.back(), bedrock.x.front(), bedrock.x.back()),
                            "Let both begin and end at the same places."});
  for (const Polyline* line : {&surface, &bedrock})
    for (const double x : line->x)
      if (!(surface.at(x) > bedrock.at(x)))
        return reader.complain("bedrock", {"the bedrock is not below the surface",
                                           fmt::format("at x = {:g} m it lies at {:g} m and the surface at {:g} m", x,
                                                       bedrock.at(x), surface.at(x)),
                                           "The ground needs a thickness everywhere."});
}

GroundProfile read_profile(SectionReader& reader, const std::filesystem::path& folder) {
  GroundProfile profile{read_line(reader, "surface", folder), read_line(reader, "bedrock", folder),
                        reader.count("cells_along"), reader.count("cells_over"), reader.quantity("room")};
  check_profile(reader, profile);
  return profile;
}

/// Cells above the line are empty: room for a body to run out into.
void read_body(SectionReader& reader, Box& box, const Reading& reading) {
  if (!reader.has("surface")) return;
  Rows rows = read_pairs(reader, "surface", reading.folder());
  check_ascending(rows, 0, false, "the x of surface");
  if (rows.size() == 1) rows.complain(0, {"surface is a single point", "a line needs two", "Add where it ends."});
  if (box.dim() == 3)
    reader.complain("surface", {"a box in space takes no surface line", "it would have to be a surface in space",
                                "Describe a section of it, or leave the line out."});
  if (reading.has_reference())
    reader.complain("surface", {"the reference has no cells that are empty", "its mesh follows the ground",
                                "Use a profile, or leave [reference] and its gates out."});
  if (rows.size() >= 2) box.surface = {rows.column[0], rows.column[1]};
}

Box read_box(SectionReader& reader, const Reading& reading) {
  Box box{reader.vector("size"), reader.counts("cells"), {}};
  read_body(reader, box, reading);
  if (!box.size.empty() && !box.cells.empty() && box.size.size() != box.cells.size())
    reader.complain("cells", {fmt::format("cells has {} numbers and size {}", box.cells.size(), box.size.size()),
                              "each direction needs both", "Write as many as there are sizes."});
  return box;
}

Extent read_extent(SectionReader& reader, const Geometry& geometry) {
  Extent extent;
  const char* const names[3] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> range = reader.range(names[axis]);
    if (reader.has("z") && axis == 2 && geometry.dim() == 2)
      reader.complain("z", {"z is not a direction of this ground", "it lies in the plane x, y", "Give x and y only."});
    if (range.empty()) continue;
    extent.from[axis] = range[0] - Extent::slack;
    extent.to[axis] = range[1] + Extent::slack;
  }
  if (!reader.has("x") && !reader.has("y") && !reader.has("z"))
    reader.missing("x", "a place needs a range of x, y or z");
  return extent;
}

void read_zones(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "zone", reading.complaints)) {
    Geometry& geometry = reading.scene.geometry;
    geometry.zones.push_back({reader.text("soil"), read_extent(reader, geometry), reader.origin_of("soil")});
    reader.finish();
  }
}

void read_parts(Reading& reading) {
  Geometry& geometry = reading.scene.geometry;
  const std::vector<std::string> sides = side_names(geometry);
  for (SectionReader& reader : sections_of(reading.root, "part", reading.complaints)) {
    const SidePart part{reader.text("name"), reader.text("of"), read_extent(reader, geometry), reader.origin()};
    const auto known = side_names(geometry);
    if (std::holds_alternative<Column>(geometry.shape))
      reader.complain_at(reader.place(), {"a column has no parts of sides", "its reference is one-dimensional",
                                          "Use a box or a slope."});
    if (std::find(known.begin(), known.end(), part.name) != known.end())
      reader.complain("name", {"there is a side '" + part.name + "' already", "two could not be told apart",
                               "Give the part another name."});
    if (!sides.empty() && !part.of.empty() && std::find(sides.begin(), sides.end(), part.of) == sides.end())
      reader.complain("of", {"there is no side '" + part.of + "'", "this geometry has " + alternatives(sides),
                             suggest(part.of, sides)});
    geometry.parts.push_back(part);
    reader.finish();
  }
}

}  // namespace

std::vector<std::string> Reading::sides() const {
  return side_names(scene.geometry);
}

void read_geometry(Reading& reading) {
  auto section = section_of(reading.root, "geometry", reading.complaints);
  if (!section) return;
  Geometry& geometry = reading.scene.geometry;
  geometry.origin = section->origin();
  if (const std::string file = section->text("mesh"); !file.empty()) {
    const std::filesystem::path mesh = reading.scene.path.parent_path() / file;
    std::error_code error;
    if (!std::filesystem::is_regular_file(mesh, error))
      section->complain("mesh", {section->shown("mesh") + " cannot be read", "there is no file " + mesh.string(),
                                 "The path is relative to the scene's folder."});
    geometry.shape = MeshFile{mesh};
  }
  if (auto column = section->table("column")) {
    geometry.shape = Column{column->quantity("height"), column->count("cells")};
    column->finish();
  }
  if (auto slope = section->table("slope")) {
    geometry.shape = Slope{slope->quantity("length"), slope->quantity("thickness"), slope->quantity("angle"),
                           slope->count("cells_along"), slope->count("cells_over")};
    slope->finish();
  }
  if (auto profile = section->table("profile")) {
    geometry.shape = read_profile(*profile, reading.folder());
    profile->finish();
  }
  if (auto box = section->table("box")) {
    geometry.shape = read_box(*box, reading);
    box->finish();
  }
  section->finish();
  read_layers(reading);
  read_zones(reading);
  read_parts(reading);
}

}  // namespace wetfront::verification
