#include "verification/scene/keys.h"

#include <stdexcept>

namespace wetfront::verification {
namespace {

const std::vector<Key>& keys() {
  static const std::vector<Key> all = [] {
    std::vector<Key> joined = ground_keys();
    for (const auto& part : {soil_keys(), condition_keys(), skeleton_keys(), run_keys()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

}  // namespace

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"", false, true, "top of the file, before the first section", {}},
      {"geometry", false, true, "where there is ground", {"column", "slope", "profile", "box", "mesh"}},
      {"geometry.column", false, false, "", {}},
      {"geometry.slope", false, false, "", {}},
      {"geometry.profile", false, false, "", {}},
      {"geometry.box", false, false, "", {}},
      {"layer",
       true,
       false,
       "one per layer, from the surface down; a lower boundary that crosses the surface or the base, or lies level in "
       "a "
       "slope or profile, is followed cell by cell, any other by the mesh",
       {}},
      {"zone",
       true,
       false,
       "a rectangle (in space a box) of another soil, over the layers and over the zones before it; followed by the "
       "mesh "
       "of a column or box, else cell by cell",
       {}},
      {"part", true, false, "a name for a part of a side", {}},
      {"water", false, false, "the pore liquid; a scene without it is dry", {}},
      {"soil",
       true,
       true,
       "one per material; in a scene with water either intrinsic_permeability or saturated_conductivity",
       {}},
      {"soil.retention", false, false, "", {}},
      {"soil.permeability", false, false, "", {}},
      {"soil.anisotropy", false, false, "", {}},
      {"soil.conductivity_field", false, false, "", {}},
      {"soil.strength", false, false, "", {}},
      {"initial",
       false,
       false,
       "pore pressure at the start; needed with water",
       {"hydrostatic", "uniform", "profile", "by_soil", "steady", "spin_up", "run", "csv", "vtu"}},
      {"initial.hydrostatic", false, false, "", {}},
      {"initial.steady", false, false, "", {}},
      {"initial.spin_up", false, false, "", {"series", "csv"}},
      {"initial.run", false, false, "", {}},
      {"rain", true, false, "rain on a side", {"intensity", "series", "csv"}},
      {"evaporation", true, false, "evaporation from a side, with or without rain", {}},
      {"boundary", true, false, "what holds on a side", {}},
      {"probe", true, false, "a gauge: pressure and saturation over time at a point", {"at", "elevation"}},
      {"rider", true, false, "a point of the soil that is followed: displacement and velocity over time", {}},
      {"skeleton", false, false, "how a skeleton that deforms starts and moves", {}},
      {"stage", true, true, "what is simulated, in order", {}},
      {"mpm", false, false, "the candidate", {}},
      {"reference", false, false, "the finite-element reference; without it nothing is compared", {}},
      {"reference.adaptive", false, false, "", {}},
      {"comparison", false, false, "when fields are kept and compared", {}},
      {"tolerance", true, false, "a gate", {}},
      {"observed",
       true,
       false,
       "what is known from an experiment or a published simulation: shown beside, gated only by a [[tolerance]] on a "
       "quantity published_...",
       {}},
  };
  return all;
}

const Section& section_named(const std::string& name) {
  for (const Section& section : sections())
    if (section.name == name) return section;
  throw std::logic_error("no section [" + name + "] in the table of keys");
}

std::vector<const Key*> keys_of(const std::string& section) {
  std::vector<const Key*> found;
  for (const Key& key : keys())
    if (key.section == section) found.push_back(&key);
  return found;
}

const Key* find_key(const std::string& section, const std::string& name) {
  for (const Key& key : keys())
    if (key.section == section && key.name == name) return &key;
  return nullptr;
}

std::string bounds(const Range& range) {
  const std::string from = (range.open_from ? "above " : "at least ") + range.from;
  const std::string to = (range.open_to ? "below " : "at most ") + range.to;
  return range.from.empty() ? to : range.to.empty() ? from : from + " and " + to;
}

std::string csv_header(const std::vector<TableColumn>& columns) {
  std::string header;
  for (const TableColumn& column : columns)
    header += (header.empty() ? "" : ", ") + column.name + " [" +
              (column.unit == "1"         ? "-"
               : column.unit == "Pa or m" ? "kPa"
                                          : column.unit) +
              "]";
  return header;
}

std::string assignment(const Key& key) {
  const bool literal = key.takes == Takes::count || key.example.find_first_of("[{") == 0 ||
                       (key.takes == Takes::quantity && key.unit == "1");
  return key.name + " = " + (literal ? key.example : '"' + key.example + '"');
}

}  // namespace wetfront::verification
