#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

Layer read_layer(SectionReader& reader, const Reading& reading) {
  Layer layer{reader.text("soil"), Layer::ToBase{}, reader.origin()};
  std::string said;
  for (const std::string name : {"thickness", "bottom", "bottom_line"}) {
    if (!reader.has(name)) continue;
    if (!said.empty())
      reader.complain(
          name, {name + " is given beside " + said, "they say the same thing in two ways", "Keep one of the two."});
    said = name;
  }
  if (reader.has("thickness")) layer.bottom = Layer::Thickness{reader.quantity("thickness")};
  if (reader.has("bottom")) layer.bottom = Layer::Elevation{reader.quantity("bottom")};
  if (reader.has("bottom_line")) {
    Rows rows = read_pairs(reader, "bottom_line", reading.folder());
    check_ascending(rows, 0, true, "the x of bottom_line");
    if (rows.size() > 0) layer.bottom = Polyline{rows.column[0], rows.column[1]};
    const Geometry& geometry = reading.scene.geometry;
    if (std::holds_alternative<Column>(geometry.shape) || geometry.dim() == 3)
      reader.complain("bottom_line", {"a line does not bound a layer here", "in a column and in space layers lie level",
                                      "Write thickness or bottom."});
  }
  return layer;
}

/// Every layer has a thickness somewhere, and the last reaches the base.
void check_filling(std::vector<SectionReader>& readers, const Geometry& geometry) {
  const std::vector<double> places = stations(geometry);
  double above_base = 0, deepest = 0;  // most and least of (bottom of the last layer - base), over the stations
  std::vector<bool> present(geometry.layers.size(), false);
  for (const double x : places) {
    const double surface = surface_at(geometry, x), base = base_at(geometry, x);
    const std::vector<double> bottoms = layer_bottoms(geometry, x);
    double above = surface;
    for (std::size_t i = 0; i < bottoms.size(); ++i) {
      if (!std::isfinite(bottoms[i]) || !std::isfinite(surface)) return;  // complained of
      present[i] = present[i] || (bottoms[i] < above && above > base + 1e-9);
      above = std::min(above, bottoms[i]);
    }
    above_base = std::max(above_base, bottoms.back() - base);
    deepest = std::min(deepest, bottoms.back() - base);
  }
  for (std::size_t i = 0; i < present.size(); ++i)
    if (!present[i])
      return readers[i].complain_at(readers[i].place(),
                                    {"the layer of '" + geometry.layers[i].soil + "' lies outside the ground",
                                     "layers are listed from the surface down, each below the one before",
                                     "Sort them, and check thickness and elevations."});
  const double slack = 1e-9 * std::max(1.0, surface_at(geometry, places.front()) - base_at(geometry, places.front()));
  const std::string repair = "Leave the thickness of the last layer out: it then reaches to the base.";
  if (above_base > slack)
    readers.back().complain_at(
        readers.back().place(),
        {"the layers do not fill the ground", fmt::format("the last ends {:g} m above the base", above_base), repair});
  if (deepest < -slack && std::holds_alternative<Layer::Thickness>(geometry.layers.back().bottom))
    readers.back().complain_at(readers.back().place(),
                               {"the layers are thicker than the ground",
                                fmt::format("the last ends {:g} m below the base", -deepest), repair});
}

}  // namespace

void read_layers(Reading& reading) {
  std::vector<SectionReader> readers = sections_of(reading.root, "layer", reading.complaints);
  if (readers.empty()) return;
  Geometry& geometry = reading.scene.geometry;
  if (std::holds_alternative<MeshFile>(geometry.shape)) {
    readers.front().complain_at(readers.front().place(),
                                {"[[layer]] is not used", "with a mesh file its regions say which soil lies where",
                                 "Remove the layers, or use [[zone]]."});
  }
  bool sound = true;
  for (std::size_t i = 0; i < readers.size(); ++i) {
    geometry.layers.push_back(read_layer(readers[i], reading));
    if (std::holds_alternative<Layer::ToBase>(geometry.layers.back().bottom) && i + 1 < readers.size()) {
      readers[i].missing("thickness", "only the last layer reaches to the base of itself");
      sound = false;
    }
    readers[i].finish();
  }
  if (sound && geometry.dim() != 0 && std::isfinite(surface_at(geometry, 0))) check_filling(readers, geometry);
}

void check_soil_names(Reading& reading) {
  const Scene& scene = reading.scene;
  const Geometry& geometry = scene.geometry;
  std::vector<std::string> names;
  for (const Soil& soil : scene.soils) names.push_back(soil.name);
  std::vector<std::string> used;
  const auto check = [&](const std::string& soil, const Origin& origin) {
    used.push_back(soil);
    if (soil.empty() || names.empty() || std::find(names.begin(), names.end(), soil) != names.end()) return;
    reading.complaints.add(
        {origin.line, origin.column},
        {"there is no soil '" + soil + "'", "the scene has " + alternatives(names), suggest(soil, names)});
  };
  for (const Layer& layer : geometry.layers) check(layer.soil, layer.origin);
  for (const Zone& zone : geometry.zones) check(zone.soil, zone.origin);
  if (std::holds_alternative<MeshFile>(geometry.shape)) return;
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const Soil& soil = scene.soils[i];
    if ((i == 0 && geometry.layers.empty()) || std::find(used.begin(), used.end(), soil.name) != used.end()) continue;
    const Place place{soil.origin.line, soil.origin.column};
    if (used.empty())
      reading.complaints.add(place, {"a second soil has no place", "nothing says where '" + soil.name + "' lies",
                                     "Remove it, or say it with [[layer]] or [[zone]], or with a mesh with regions."});
    else
      reading.complaints.add(place, {"the soil '" + soil.name + "' lies nowhere",
                                     "no [[layer]] and no [[zone]] is made of it", "Remove it, or place it."});
  }
}

}  // namespace wetfront::verification
