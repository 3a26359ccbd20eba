#include "verification/scene/keys.h"

/// The table: skeletons that deform.
namespace wetfront::verification {

// clang-format off
std::vector<Key> skeleton_keys() {
  constexpr auto required = Presence::required;
  constexpr auto optional = Presence::optional;
  const std::vector<std::string> frictional = {"mohr-coulomb", "softening-mohr-coulomb", "suction-mohr-coulomb"}, softening = {"softening-mohr-coulomb"},
                                 suction = {"suction-mohr-coulomb"}, cam_clay = {"modified-cam-clay"};
  return {
    {"soil.strength", "law", Takes::choice, "", required, "", "perfectly plastic; falling to residual values with plastic shear strain; growing with suction (Yerro 2015); or modified Cam-Clay (which has no use for young)", "mohr-coulomb", {},
     {"mohr-coulomb", "softening-mohr-coulomb", "suction-mohr-coulomb", "modified-cam-clay"}},
    {"soil.strength", "friction", Takes::quantity, "rad", required, "", "effective friction angle", "34 deg", {"0 deg", "70 deg"}, {}, "law", frictional},
    {"soil.strength", "cohesion", Takes::quantity, "Pa", optional, "0 Pa", "effective cohesion", "5 kPa", {"0 Pa", "1 GPa"}, {}, "law", frictional},
    {"soil.strength", "dilatancy", Takes::quantity, "rad", optional, "0 deg", "dilatancy angle; that of friction makes the flow rule associated, a negative one the soil contractive", "0 deg", {"-30 deg", "70 deg"}, {}, "law", frictional},
    {"soil.strength", "tension_cut_off", Takes::quantity, "Pa", optional, "", "largest tensile stress; the apex of the cone when absent", "0 Pa", {"0 Pa", "1 GPa"}, {}, "law", frictional},
    {"soil.strength", "residual_friction", Takes::quantity, "rad", required, "", "friction angle at large shear strain", "28 deg", {"0 deg", "70 deg"}, {}, "law", softening},
    {"soil.strength", "residual_cohesion", Takes::quantity, "Pa", optional, "0 Pa", "cohesion there", "0 Pa", {"0 Pa", "1 GPa"}, {}, "law", softening},
    {"soil.strength", "residual_dilatancy", Takes::quantity, "rad", optional, "0 deg", "dilatancy angle there", "0 deg", {"-30 deg", "70 deg"}, {}, "law", softening},
    {"soil.strength", "softening_range", Takes::quantity, "1", required, "", "plastic shear strain over which strength falls, linearly", "0.3", {"0", "100", true}, {}, "law", softening},
    {"soil.strength", "suction_cohesion", Takes::quantity, "Pa", required, "", "cohesion that suction adds at most", "5 kPa", {"0 Pa", "1 GPa"}, {}, "law", suction},
    {"soil.strength", "cohesion_rate", Takes::quantity, "1", required, "", "B of c = c' + c_max (1 - exp(-B s / p_atm))", "5", {"0", "1e6"}, {}, "law", suction},
    {"soil.strength", "friction_rate", Takes::quantity, "rad", optional, "0 deg", "A of phi = phi' + A s / p_atm", "0 deg", {"0 deg", "70 deg"}, {}, "law", suction},
    {"soil.strength", "critical_slope", Takes::quantity, "1", required, "", "M, slope of the critical-state line in q over p'", "1.2", {"0", "3", true}, {}, "law", cam_clay},
    {"soil.strength", "compression", Takes::quantity, "1", required, "", "lambda, slope of virgin compression in e over ln p'", "0.1", {"0", "10", true}, {}, "law", cam_clay},
    {"soil.strength", "swelling", Takes::quantity, "1", required, "", "kappa, slope of swelling; below lambda", "0.02", {"0", "10", true}, {}, "law", cam_clay},
    {"soil.strength", "preconsolidation", Takes::quantity, "Pa", required, "", "largest isotropic pressure that the soil has seen", "100 kPa", {"0 Pa", "1 GPa", true}, {}, "law", cam_clay},

    {"skeleton", "initial_stress", Takes::choice, "", optional, "none", "k0 lets each point carry what lies above it, with the soils' earth_pressure_at_rest sideways; none is zero effective stress, which a first quasi-static stage can relax", "k0", {}, {"none", "k0"}},
    {"skeleton", "shape", Takes::choice, "", optional, "linear", "shape functions of the motion; quadratic-spline needs a mesh of equal rectangles", "linear", {}, {"linear", "quadratic-spline"}},
    {"skeleton", "stress_update", Takes::choice, "", optional, "musl", "when stress is updated in a step: after momenta are mapped back (Lee 2021, steps I to IX), first, or last", "musl", {}, {"musl", "usf", "usl"}},
    {"skeleton", "transfer", Takes::choice, "", optional, "flip", "how velocities pass between nodes and points", "flip", {}, {"flip", "apic"}},
    {"skeleton", "pic", Takes::quantity, "1", optional, "0", "share of the nodes' velocities themselves in each step: damps what rings", "0.001", {"0", "1"}, {}, "transfer", {"flip"}},
    {"skeleton", "locking", Takes::choice, "", optional, "b-bar", "cure of volumetric locking: strain of volume and mean stress act with the cell's mean gradient", "b-bar", {}, {"b-bar", "none"}},
    {"skeleton", "integration", Takes::choice, "", optional, "automatic", "where stress is integrated: inside a body the mean stress of a cell over the cell's own volume (mixed), or at the points alone, where forces jump whenever a point crosses; automatic is mixed in stages without water, at the points with it", "mixed", {}, {"automatic", "mixed", "points"}},
  };
}
// clang-format on

}  // namespace wetfront::verification
