#include "verification/scene/keys.h"

/// The table: initial state, rain, evaporation, what holds on sides, probes.
namespace wetfront::verification {

// clang-format off
std::vector<Key> condition_keys() {
  constexpr auto required = Presence::required;
  constexpr auto optional = Presence::optional;
  const std::string pa = "Pa or m";
  return {
    {"initial", "hydrostatic", Takes::table, "", optional, "", "at rest above and below a water table", R"({ water_table = "0 m", suction_cap = "10 kPa" })"},
    {"initial", "uniform", Takes::quantity, pa, optional, "", "the same pore pressure everywhere; suction is negative", "-10 kPa", {"-10 GPa", "1 GPa"}},
    {"initial", "profile", Takes::pairs, "", optional, "", "pore pressure over elevation: linear between the rows, constant beyond; an elevation given twice is a jump", R"([["0 m", "0 kPa"], ["1.2 m", "-8 kPa"]])", {}, {}, "", {},
     {{"elevation", "m"}, {"pressure", pa}}},
    {"initial", "by_soil", Takes::pressures, pa, optional, "", "one pore pressure per soil; between two soils their mean", R"([["sand", "-4 kPa"], ["clay", "-30 kPa"]])", {"-10 GPa", "1 GPa"}},
    {"initial", "steady", Takes::table, "", optional, "", "the steady state under antecedent rain on the sides that are rained on, everything else as at the start", R"({ rain = "1 mm/h" })"},
    {"initial", "spin_up", Takes::table, "", optional, "", "what the reference makes of a record of rain before the start, the sides as at the start", R"({ csv = "antecedent.csv", duration = "30 d", water_table = "0 m" })"},
    {"initial", "run", Takes::table, "", optional, "", "the reference's field of a former run", R"({ folder = "../out/wet_season", time = "30 d" })"},
    {"initial", "csv", Takes::path, "", optional, "", "file with the header `x [m], y [m], pressure [kPa]` (in space also z, after y) or `elevation [m], pressure [kPa]`: bilinear on a grid of places, else the nearest place counts", "start.csv"},
    {"initial", "vtu", Takes::path, "", optional, "", "a field file that a former run has left", "../out/wet_season/fields/reference_grid_0002.vtu"},
    {"initial.hydrostatic", "water_table", Takes::level, "m", required, "", "elevation of the water table (see from); in a section also a line, x ascending: straight between its points, level beyond them, pressures hydrostatic along the vertical", "0 m", {"-100 km", "100 km"}, {}, "", {}, {{"x", "m"}, {"y", "m"}}},
    {"initial.hydrostatic", "from", Takes::choice, "", optional, "datum", "what water_table is measured from: elevation zero, or the lower end of the ground below each place, which a thin wet layer over a steep base comes nearer to", "base", {}, {"datum", "base"}},
    {"initial.hydrostatic", "suction_cap", Takes::quantity, pa, optional, "", "no suction above this one; no cap when absent", "10 kPa", {"0 Pa", "10 GPa"}},
    {"initial.steady", "rain", Takes::quantity, "m/s", required, "", "its intensity per horizontal area", "1 mm/h", {"0 m/s", "0.1 m/s"}},
    {"initial.spin_up", "series", Takes::series, "", optional, "", "[time, intensity] pairs from the start of the spin-up; each holds until the next", R"([["0 d", "2 mm/h"], ["2 d", "0 mm/h"]])"},
    {"initial.spin_up", "csv", Takes::path, "", optional, "", "the same in a file with the header `time [s], intensity [mm/h]`", "antecedent.csv"},
    {"initial.spin_up", "duration", Takes::quantity, "s", required, "", "how long; its end is the start of the run", "30 d", {"0 s", "100000 d", true}},
    {"initial.spin_up", "water_table", Takes::quantity, "m", required, "", "the spin-up starts at rest over a water table at this elevation", "0 m", {"-100 km", "100 km"}},
    {"initial.spin_up", "suction_cap", Takes::quantity, pa, optional, "", "with no suction above this one", "10 kPa", {"0 Pa", "10 GPa"}},
    {"initial.run", "folder", Takes::path, "", required, "", "its output folder", "../out/wet_season"},
    {"initial.run", "time", Takes::quantity, "s", optional, "", "the time of one of its fields; the last when absent", "30 d", {"0 s", "100000 d"}},

    {"rain", "side", Takes::text, "", required, "", "where it falls; what the soil does not take runs off", "top"},
    {"rain", "intensity", Takes::quantity, "m/s", optional, "", "constant intensity per horizontal area", "30 mm/h", {"0 m/s", "0.1 m/s"}},
    {"rain", "series", Takes::series, "", optional, "", "[time, intensity] pairs; each holds until the next", R"([["0 s", "100 mm/h"], ["1 h", "0 mm/h"]])"},
    {"rain", "csv", Takes::path, "", optional, "", "the same in a file with the header `time [s], intensity [mm/h]`", "rain.csv"},

    {"evaporation", "side", Takes::text, "", required, "", "where it acts", "top"},
    {"evaporation", "demand", Takes::record, "m/s", required, "", "per horizontal area; pairs hold until the next", "4 mm/d", {"0 m/s", "1e-4 m/s"}, {}, "", {}, {{"time", "s"}, {"demand", "m/s"}}},
    {"evaporation", "least_pressure", Takes::quantity, pa, optional, "-150 m", "no drier than this: from there on the soil gives what it can, not what is asked", "-1.5 MPa", {"-10 GPa", "0 Pa"}},

    {"boundary", "side", Takes::text, "", required, "", "a side of the geometry, or a part of one", "base"},
    {"boundary", "water", Takes::choice, "", optional, "", "for the water; impermeable when absent and no rain falls; as-at-start holds the initial pressure; water-level is a lake or river: hydrostatic below its surface, seepage face or rain above", "impermeable", {},
     {"impermeable", "free-drainage", "pressure", "seepage-face", "total-head", "flux", "water-level", "as-at-start", "periodic"}},
    {"boundary", "pressure", Takes::record, pa, required, "", "the pore pressure there; pairs are joined by straight lines", "0 kPa", {"-10 GPa", "1 GPa"}, {}, "water", {"pressure"}, {{"time", "s"}, {"pressure", pa}}},
    {"boundary", "head", Takes::record, "m", required, "", "the total head, elevation included: hydrostatic along the side; pairs are joined by straight lines", "1.5 m", {"-100 km", "100 km"}, {}, "water", {"total-head"}, {{"time", "s"}, {"head", "m"}}},
    {"boundary", "level", Takes::record, "m", required, "", "elevation of the water surface; pairs are joined by straight lines", R"([["0 d", "2 m"], ["3 d", "5 m"]])", {"-100 km", "100 km"}, {}, "water", {"water-level"}, {{"time", "s"}, {"level", "m"}}},
    {"boundary", "inflow", Takes::record, "m/s", required, "", "per area of the side, negative out; what the soil does not take or give is not imposed; pairs hold until the next", "2 cm/d", {"-0.1 m/s", "0.1 m/s"}, {}, "water", {"flux"}, {{"time", "s"}, {"inflow", "m/s"}}},
    {"boundary", "least_pressure", Takes::quantity, pa, optional, "-150 m", "a flux out dries the side no further than this", "-1.5 MPa", {"-10 GPa", "0 Pa"}, {}, "water", {"flux"}},
    {"boundary", "partner", Takes::text, "", optional, "", "of what is periodic: the side where what leaves here comes in; the same shape, moved", "right"},
    {"boundary", "skeleton", Takes::choice, "", optional, "", "for a skeleton that deforms; roller holds the direction across the side, contact is a rigid base with friction on which the body may slide and from which it may lift, absorbing lets waves out", "fixed", {},
     {"fixed", "roller", "free", "fixed-x", "fixed-y", "moving", "moving-x", "moving-y", "contact", "absorbing", "periodic"}},
    {"boundary", "velocity", Takes::vector, "m/s", required, "", "given to the skeleton; moving-x and moving-y take their component and leave the other free", R"(["0 m/s", "-1 mm/s"])", {"-100 m/s", "100 m/s"}, {}, "skeleton", {"moving", "moving-x", "moving-y"}},
    {"boundary", "base_friction", Takes::quantity, "rad", required, "", "angle of friction between body and base", "34 deg", {"0 deg", "89 deg"}, {}, "skeleton", {"contact"}},
    {"boundary", "load", Takes::record, "Pa", optional, "", "pressure on the skeleton, against the outward normal; pairs are joined by straight lines", "10 kPa", {"-1 GPa", "1 GPa"}, {}, "", {}, {{"time", "s"}, {"load", "Pa"}}},
    {"boundary", "traction", Takes::vectors, "Pa", optional, "", "force on the skeleton per area of the side, along x and y, besides a load; rows are joined by straight lines", R"(["5 kPa", "-10 kPa"])", {"-1 GPa", "1 GPa"}, {}, "", {}, {{"time", "s"}, {"x", "Pa"}, {"y", "Pa"}}},

    {"rider", "name", Takes::text, "", required, "", "name of the point", "D-1"},
    {"rider", "at", Takes::vector, "m", required, "", "its place at the start; the nearest material point is followed", R"(["17 m", "5.2 m"])", {"-1000 km", "1000 km"}},
    {"probe", "name", Takes::text, "", required, "", "name of the gauge", "base"},
    {"probe", "at", Takes::vector, "m", optional, "", "position x, y (in space x, y, z)", R"(["0 m", "0.6 m"])", {"-1000 km", "1000 km"}},
    {"probe", "elevation", Takes::quantity, "m", optional, "", "the same in a column", "0.6 m", {"-100 km", "100 km"}},
  };
}
// clang-format on

}  // namespace wetfront::verification
