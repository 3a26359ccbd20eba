#include "verification/scene/keys.h"

#include "verification/scene/quantities.h"

#include <stdexcept>

namespace wetfront::verification {
namespace {

constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.push_back(quantity.name);
  return names;
}

// Ranges are wide on purpose: they catch slips of a unit or an exponent, not unusual soils.
// clang-format off
std::vector<Key> ground_keys() {
  return {
    {"", "title", Takes::text, "", required, "", "one line for the head of the report", "Seed column"},
    {"", "requirement", Takes::text, "", optional, "", "the sentence that the scene is there to show", "The MPM follows the wetting front."},
    {"", "gravity", Takes::vector, "m/s2", optional, "0 m/s2, -9.81 m/s2", "acceleration of gravity, y up; zeros: none",
     R"(["0 m/s2", "-9.81 m/s2"])", {"-1000 m/s2", "1000 m/s2"}},

    {"geometry", "column", Takes::table, "", optional, "", "a column with sides top, base, left, right", R"({ height = "1.2 m", cells = 40 })"},
    {"geometry", "slope", Takes::table, "", optional, "", "an inclined layer that rises to the right, with the same sides",
     R"({ length = "20 m", thickness = "1.2 m", angle = "30 deg", cells_along = 80, cells_over = 10 })"},
    {"geometry", "mesh", Takes::path, "", optional, "", "your own gmsh mesh, sides and regions as physical groups", "ground.msh"},
    {"geometry.column", "height", Takes::quantity, "m", required, "", "height", "1.2 m", {"1 mm", "10 km"}},
    {"geometry.column", "cells", Takes::count, "", required, "", "equal cells over the height", "40", {"1", "100000"}},
    {"geometry.slope", "length", Takes::quantity, "m", required, "", "horizontal length", "20 m", {"1 mm", "100 km"}},
    {"geometry.slope", "thickness", Takes::quantity, "m", required, "", "vertical thickness", "1.2 m", {"1 mm", "10 km"}},
    {"geometry.slope", "angle", Takes::quantity, "rad", required, "", "inclination", "30 deg", {"0 deg", "80 deg"}},
    {"geometry.slope", "cells_along", Takes::count, "", required, "", "cells along the slope", "80", {"1", "100000"}},
    {"geometry.slope", "cells_over", Takes::count, "", required, "", "cells over the thickness", "10", {"1", "100000"}},

    {"water", "density", Takes::quantity, "kg/m3", optional, "1000 kg/m3", "density", "1000 kg/m3", {"100 kg/m3", "20000 kg/m3"}},
    {"water", "bulk_modulus", Takes::quantity, "Pa", optional, "2.2 GPa", "bulk modulus", "2.2 GPa", {"1 kPa", "1000 GPa"}},
    {"water", "viscosity", Takes::quantity, "Pa s", optional, "1e-6 kPa s", "dynamic viscosity", "1e-6 kPa s", {"1e-7 Pa s", "1e3 Pa s"}},

    {"soil", "name", Takes::text, "", required, "", "name; with a mesh file that of its region", "sand"},
    {"soil", "porosity", Takes::quantity, "1", required, "", "volume of pores over volume", "0.46", {"0", "1", true, true}},
    {"soil", "grain_density", Takes::quantity, "kg/m3", required, "", "density of the grains", "2690 kg/m3", {"500 kg/m3", "20000 kg/m3"}},
    {"soil", "intrinsic_permeability", Takes::quantity, "m2", optional, "", "permeability of the saturated soil",
     "3e-11 m2", {"1e-22 m2", "1e-5 m2"}},
    {"soil", "saturated_conductivity", Takes::quantity, "m/s", optional, "", "the same as k rho g / mu", "2.9e-4 m/s", {"1e-16 m/s", "10 m/s"}},
    {"soil", "retention", Takes::table, "", optional, "", "water retention curve; needed with water",
     R"({ law = "van-genuchten", air_entry = "4.35 kPa", lambda = 0.61, S_min = 0.087, S_max = 1 })"},
    {"soil", "permeability", Takes::table, "", optional, "", "relative permeability; mualem when absent", R"({ law = "mualem" })"},
    {"soil", "young", Takes::quantity, "Pa", optional, "", "Young's modulus of an elastic skeleton; rigid when absent", "10 MPa", {"1 Pa", "1000 GPa"}},
    {"soil", "poisson", Takes::quantity, "1", optional, "", "Poisson's ratio; needed with young", "0.3", {"0", "0.5", false, true}},
    {"soil.retention", "law", Takes::choice, "", required, "", "van Genuchten 1980 (Lee 2021, Eq. 5) or Gardner 1958", "van-genuchten", {}, {"van-genuchten", "exponential"}},
    {"soil.retention", "air_entry", Takes::quantity, "Pa", required, "", "p0 of Lee 2021, Eq. 5", "4.35 kPa", {"0 Pa", "1 GPa", true}, {}, "law", {"van-genuchten"}},
    {"soil.retention", "lambda", Takes::quantity, "1", required, "", "lambda = 1 - 1/n", "0.61", {"0", "1", true, true}, {}, "law", {"van-genuchten"}},
    {"soil.retention", "suction_scale", Takes::quantity, "Pa", required, "", "p_c of S = S_min + (S_max - S_min) exp(-s/p_c)", "0.98 kPa", {"0 Pa", "1 GPa", true}, {}, "law", {"exponential"}},
    {"soil.retention", "S_min", Takes::quantity, "1", required, "", "residual degree of saturation", "0.087", {"0", "1", false, true}},
    {"soil.retention", "S_max", Takes::quantity, "1", optional, "1", "largest degree of saturation", "1", {"0", "1", true}},
    {"soil.permeability", "law", Takes::choice, "", required, "",
     "mualem; printed-mualem is Lee 2021, Eq. 7 as printed and mualem-of-saturation takes S for Se: both are known defects, kept to show what they cost",
     "mualem", {}, {"mualem", "printed-mualem", "mualem-of-saturation", "exponential", "constant"}},
    {"soil.permeability", "suction_scale", Takes::quantity, "Pa", optional, "", "k_rel = exp(-s/scale); that of an exponential retention when absent", "0.98 kPa",
     {"0 Pa", "1 GPa", true}, {}, "law", {"exponential"}},

    {"initial", "hydrostatic", Takes::table, "", optional, "", "at rest above and below a water table", R"({ water_table = "0 m", suction_cap = "10 kPa" })"},
    {"initial", "uniform", Takes::quantity, "Pa", optional, "", "the same pore pressure everywhere; suction is negative", "-10 kPa", {"-10 GPa", "1 GPa"}},
    {"initial.hydrostatic", "water_table", Takes::quantity, "m", required, "", "elevation of the water table", "0 m", {"-100 km", "100 km"}},
    {"initial.hydrostatic", "suction_cap", Takes::quantity, "Pa", optional, "", "no suction above this one; no cap when absent", "10 kPa", {"0 Pa", "10 GPa"}},
  };
}

std::vector<Key> boundary_keys() {
  return {
    {"rain", "side", Takes::text, "", required, "", "where it falls; what the soil does not take runs off", "top"},
    {"rain", "intensity", Takes::quantity, "m/s", optional, "", "constant intensity per horizontal area", "30 mm/h", {"0 m/s", "0.1 m/s"}},
    {"rain", "series", Takes::series, "", optional, "", "[time, intensity] pairs; each holds until the next", R"([["0 s", "100 mm/h"], ["1 h", "0 mm/h"]])"},
    {"rain", "csv", Takes::path, "", optional, "", "the same in a file with the header `time [s], intensity [mm/h]`", "rain.csv"},

    {"boundary", "side", Takes::text, "", required, "", "a side of the geometry", "base"},
    {"boundary", "water", Takes::choice, "", optional, "", "for the water; impermeable when absent and no rain falls", "impermeable", {},
     {"impermeable", "free-drainage", "pressure", "seepage-face"}},
    {"boundary", "pressure", Takes::quantity, "Pa", required, "", "the pore pressure there", "0 kPa", {"-10 GPa", "1 GPa"}, {}, "water", {"pressure"}},
    {"boundary", "skeleton", Takes::choice, "", optional, "", "for an elastic skeleton; roller holds the direction across the side", "fixed", {},
     {"fixed", "roller", "free", "fixed-x", "fixed-y"}},

    {"probe", "name", Takes::text, "", required, "", "name of the gauge", "base"},
    {"probe", "at", Takes::vector, "m", optional, "", "position x, y", R"(["0 m", "0.6 m"])", {"-1000 km", "1000 km"}},
    {"probe", "elevation", Takes::quantity, "m", optional, "", "the same in a column", "0.6 m", {"-100 km", "100 km"}},
  };
}

std::vector<Key> run_keys() {
  return {
    {"stage", "name", Takes::text, "", required, "", "name", "infiltration"},
    {"stage", "scheme", Takes::choice, "", optional, "", "how the pore water moves: seepage without inertia, implicit-drag with; needed with water",
     "seepage", {}, {"seepage", "implicit-drag"}},
    {"stage", "until", Takes::time, "s", required, "", "end of the stage since the start of the run", "110 % of filling"},
    {"stage", "time_integrator", Takes::choice, "", optional, "bdf2", "of seepage", "bdf2", {}, {"bdf2", "backward-euler"}, "scheme", {"seepage"}},
    {"stage", "time_tolerance", Takes::quantity, "1", optional, "1e-5", "of the error control of seepage", "1e-5", {"1e-12", "0.1"}, {}, "scheme", {"seepage"}},
    {"stage", "largest_step", Takes::quantity, "s", optional, "", "no step longer than this; no limit when absent", "10 s", {"0 s", "1000 d", true}},
    {"stage", "step_safety", Takes::quantity, "1", optional, "0.8", "fraction of the stability limit that conditionally stable schemes use", "0.8", {"0", "1", true}},
    {"stage", "local_damping", Takes::quantity, "1", optional, "0", "of the skeleton's out-of-balance force (Cundall)", "0.05", {"0", "1", false, true}},
    {"stage", "mass_balance", Takes::choice, "", optional, "conservative", "printed-2021 is Lee 2021, Eqs 4 and 18 as printed, which loses rain: a known defect, kept to show what it costs", "conservative",
     {}, {"conservative", "printed-2021"}, "scheme", {"implicit-drag"}},

    {"mpm", "points_per_cell", Takes::count, "", optional, "4", "material points per cell, a square number", "4", {"1", "25"}},

    {"reference", "cells", Takes::count, "", optional, "320", "cells over the height of a column or the thickness of a slope; a mesh file is halved until it has that many", "320", {"2", "100000"}},
    {"reference", "tolerance", Takes::quantity, "1", optional, "1e-6", "relative tolerance of the time integration", "1e-6", {"1e-12", "0.01"}},
    {"reference", "integrator", Takes::choice, "", optional, "bdf", "backward-euler is the cross-check", "bdf", {}, {"bdf", "backward-euler"}},

    {"comparison", "times", Takes::times, "", required, "", "when fields are kept and compared, ascending", R"(["25 % of filling", "50 % of filling"])"},

    {"tolerance", "quantity", Takes::choice, "", required, "", "what is gated; the table of quantities is below", "pressure_l2", {}, quantity_names()},
    {"tolerance", "at", Takes::time, "s", optional, "", "one of the comparison times; all of them when absent", "25 % of filling"},
    {"tolerance", "probe", Takes::text, "", optional, "", "one probe, for quantities of probes; every probe when absent", "base"},
    {"tolerance", "value", Takes::tolerance, "", required, "", "largest allowed error: \"1 %\", or with the unit of the quantity", "1 %"},
    {"tolerance", "reason", Takes::text, "", required, "", "where this number comes from", "spatial error of a good scheme at 40 cells, doubled"},
  };
}
// clang-format on

const std::vector<Key>& keys() {
  static const std::vector<Key> all = [] {
    std::vector<Key> joined = ground_keys();
    for (const auto& part : {boundary_keys(), run_keys()}) joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

}  // namespace

const std::vector<Section>& sections() {
  static const std::vector<Section> all = {
      {"", false, true, "top of the file, before the first section", {}},
      {"geometry", false, true, "where there is ground", {"column", "slope", "mesh"}},
      {"geometry.column", false, false, "", {}},
      {"geometry.slope", false, false, "", {}},
      {"water", false, false, "the pore liquid; a scene without it is dry", {}},
      {"soil",
       true,
       true,
       "one per material; in a scene with water either intrinsic_permeability or saturated_conductivity",
       {}},
      {"soil.retention", false, false, "", {}},
      {"soil.permeability", false, false, "", {}},
      {"initial", false, false, "pore pressure at the start; needed with water", {"hydrostatic", "uniform"}},
      {"initial.hydrostatic", false, false, "", {}},
      {"rain", true, false, "rain on a side", {"intensity", "series", "csv"}},
      {"boundary", true, false, "what holds on a side", {}},
      {"probe", true, false, "a gauge: pressure and saturation over time at a point", {"at", "elevation"}},
      {"stage", true, true, "what is simulated, in order", {}},
      {"mpm", false, false, "the candidate", {}},
      {"reference", false, false, "the finite-element reference; without it nothing is compared", {}},
      {"comparison", false, false, "when fields are kept and compared", {}},
      {"tolerance", true, false, "a gate", {}},
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

std::string assignment(const Key& key) {
  const bool literal = key.takes == Takes::vector || key.takes == Takes::series || key.takes == Takes::times ||
                       key.takes == Takes::table || key.takes == Takes::count ||
                       (key.takes == Takes::quantity && key.unit == "1");
  return key.name + " = " + (literal ? key.example : '"' + key.example + '"');
}

}  // namespace wetfront::verification
