#include "verification/scene/keys.h"

#include "verification/scene/quantities.h"

/// The table: stages, solvers, comparison, gates.
namespace wetfront::verification {
namespace {

constexpr auto required = Presence::required;
constexpr auto optional = Presence::optional;

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.push_back(quantity.name);
  return names;
}

}  // namespace

// clang-format off
std::vector<Key> run_keys() {
  return {
    {"stage", "name", Takes::text, "", required, "", "name", "infiltration"},
    {"stage", "scheme", Takes::choice, "", optional, "", "how the pore water moves, cheapest first: seepage without inertia, semi-implicit with that of the water (a skeleton that deforms is dynamic then), implicit-drag with two velocities, explicit as Lee 2021; auto takes the cheapest that the scene allows; needed with water, but for the reference alone",
     "seepage", {}, {"auto", "seepage", "semi-implicit", "implicit-drag", "explicit"}},
    {"stage", "until", Takes::time, "s", optional, "", "end of the stage since the start of the run, the latest where an event may end it; needed but with lasts", "110 % of filling"},
    {"stage", "lasts", Takes::quantity, "s", optional, "", "in place of until: end of the stage since its own beginning, for stages that begin with an event", "12 s", {"0 s", "100000 d", true}},
    {"stage", "ends_with", Takes::choice, "", optional, "time", "what may end it earlier: failure of a quasi-static skeleton, whose last equilibrium the next stage begins with; rest of a dynamic one", "failure", {}, {"time", "failure", "rest"}},
    {"stage", "failure_displacement", Takes::quantity, "m", optional, "2 cm", "a skeleton of which a twentieth moves so far in one step, shrunk to shortest_step, has failed", "2 cm", {"0 m", "1 km", true}, {}, "ends_with", {"failure"}},
    {"stage", "failure_ratio", Takes::quantity, "1", optional, "5e-3", "a relaxation that runs out of iterations with more of the forces out of balance has failed, with less it has stalled", "5e-3", {"0", "1", true}, {}, "ends_with", {"failure"}},
    {"stage", "shortest_step", Takes::quantity, "s", optional, "2 s", "steps of the water are halved down to this before failure is believed: the time of failure is known to it", "2 s", {"0 s", "1000 d", true}, {}, "ends_with", {"failure"}},
    {"stage", "rest_energy", Takes::quantity, "1", optional, "1e-3", "kinetic energy over the largest of the stage below which the body is at rest", "1e-3", {"0", "1", true}, {}, "ends_with", {"rest"}},
    {"stage", "rest_hold", Takes::quantity, "s", optional, "0.2 s", "for so long", "0.2 s", {"0 s", "1 d", true}, {}, "ends_with", {"rest"}},
    {"stage", "picture_every", Takes::quantity, "s", optional, "", "pictures of the body as often, and at the ends of stages that an event ends; when absent, 20 in the plane over a stage that ends with failure, else none", "0.5 s", {"0 s", "1000 d", true}},
    {"stage", "coupling_tolerance", Takes::quantity, "1", optional, "1e-6", "agreement of flow and quasi-static skeleton in a step, as relative pressure", "1e-6", {"1e-12", "0.01"}},
    {"stage", "time_integrator", Takes::choice, "", optional, "bdf2", "of seepage", "bdf2", {}, {"bdf2", "backward-euler"}, "scheme", {"auto", "seepage"}},
    {"stage", "time_tolerance", Takes::quantity, "1", optional, "1e-5", "of the error control of seepage and semi-implicit", "1e-5", {"1e-12", "0.1"}, {}, "scheme", {"auto", "seepage", "semi-implicit"}},
    {"stage", "largest_step", Takes::quantity, "s", optional, "", "no step longer than this; no limit when absent", "10 s", {"0 s", "1000 d", true}},
    {"stage", "step_safety", Takes::quantity, "1", optional, "0.8", "fraction of the stability limit that conditionally stable schemes use", "0.8", {"0", "1", true}},
    {"stage", "local_damping", Takes::quantity, "1", optional, "0", "of the skeleton's out-of-balance force (Cundall)", "0.05", {"0", "1", false, true}},
    {"stage", "skeleton", Takes::choice, "", optional, "", "of a skeleton that deforms: dynamic moves in true time, quasi-static goes from equilibrium to equilibrium; quasi-static with seepage, else dynamic when absent", "quasi-static", {}, {"dynamic", "quasi-static"}},
    {"stage", "unbalanced_ratio", Takes::quantity, "1", optional, "2e-4", "out-of-balance force over forces below which a quasi-static skeleton is at rest", "2e-4", {"1e-12", "0.1"}},
    {"stage", "relaxation_damping", Takes::quantity, "1", optional, "0.7", "local damping on the way to equilibrium", "0.7", {"0", "1", true, true}},
    {"stage", "mass_balance", Takes::choice, "", optional, "conservative", "printed-2021 is Lee 2021, Eqs 4 and 18 as printed, which loses rain: a known defect, kept to show what it costs", "conservative",
     {}, {"conservative", "printed-2021"}, "scheme", {"implicit-drag", "explicit"}},

    {"mpm", "points_per_cell", Takes::count, "", optional, "4", "material points per cell, a square number", "4", {"1", "25"}},
    {"mpm", "threads", Takes::count, "", optional, "1", "of the kernels over cells; results do not depend on it", "2", {"1", "256"}},
    {"mpm", "surface_in_cell", Takes::quantity, "1", optional, "1", "filled fraction of the topmost row of cells: below 1 the surface lies inside them, as it does once a body moves", "0.3", {"0.01", "1"}},
    {"mpm", "water_softening", Takes::quantity, "1", optional, "1", "bulk modulus of the MPM's water over the scene's, which the reference keeps: below 1 the water is softer, so that two velocities may take longer steps; the comparison shows what that costs", "0.1", {"1e-4", "1"}},
    {"mpm", "rainfall", Takes::choice, "", optional, "standard", "where rain enters when the surface lies inside cells; the named ones of the literature are there for research", "standard", {}, {"standard", "martinelli-2020", "bandara-2016", "consistent-flux"}},
    {"mpm", "accuracy", Takes::quantity, "1", optional, "", "cells and time steps are refined until the run's own estimated error of pressure (relative L2 at the comparison times) is within this; as the scene's cells give it when absent", "1 %", {"1e-6", "0.5"}},
    {"mpm", "cpu_budget", Takes::quantity, "s", optional, "1 d", "CPU time that the run may take: a plan that expects more is refused, a run that takes more stops and keeps what it has", "600 s", {"1 ms", "1000 d"}},

    {"reference", "cells", Takes::count, "", optional, "", "cells over the height of a column (320 when absent), the thickness of a slope or profile or the height of a box (their own when absent); a mesh file is halved until it has that many",
     "320", {"1", "100000"}},
    {"reference", "tolerance", Takes::quantity, "1", optional, "1e-6", "relative tolerance of the time integration", "1e-6", {"1e-12", "0.01"}},
    {"reference", "integrator", Takes::choice, "", optional, "bdf", "bdf is variable-order (SUNDIALS IDA), dirk diagonally implicit Runge-Kutta (ARKStep); backward-euler is the cross-check", "bdf", {}, {"bdf", "backward-euler", "dirk"}},
    {"reference", "degree", Takes::count, "", optional, "1", "of the elements: 1, or 2 for smooth fields", "1", {"1", "2"}},
    {"reference", "adaptive", Takes::table, "", optional, "", "a mesh that is refined towards wetting fronts (not in a column); fixed when absent", R"({ levels = 2, threshold = 1e-3 })"},
    {"reference", "skeleton_storage", Takes::choice, "", optional, "none", "storage S (chi + p dchi/dp) / E_oed of the soils that have young, chi being Bishop's parameter", "saturation", {}, {"none", "saturation", "effective-saturation"}},
    {"reference.adaptive", "levels", Takes::count, "", optional, "2", "how often a cell may be halved", "2", {"1", "6"}},
    {"reference.adaptive", "threshold", Takes::quantity, "1", optional, "1e-3", "error in water content beyond which a cell is halved", "1e-3", {"1e-8", "0.5"}},

    {"comparison", "times", Takes::times, "", required, "", "when fields are kept and compared, ascending", R"(["25 % of filling", "50 % of filling"])"},
    {"comparison", "second_mesh", Takes::choice, "", optional, "none", "runs the MPM again on cells twice as large, or half as large, and shows what came out of it beside what is known and came out: the numerical doubt of a slide", "coarser", {}, {"none", "coarser", "finer"}},

    {"tolerance", "quantity", Takes::choice, "", required, "", "what is gated; the table of quantities is below", "pressure_l2", {}, quantity_names()},
    {"tolerance", "at", Takes::time, "s", optional, "", "one of the comparison times; all of them when absent", "25 % of filling"},
    {"tolerance", "probe", Takes::text, "", optional, "", "one probe, for quantities of probes; every probe when absent", "base"},
    {"tolerance", "value", Takes::tolerance, "", required, "", "largest allowed error: \"1 %\", or with the unit of the quantity", "1 %"},
    {"tolerance", "reason", Takes::text, "", required, "", "where this number comes from", "spatial error of a good scheme at 40 cells, doubled"},
    {"observed", "quantity", Takes::text, "", required, "", "failure_time, slide_duration, largest_displacement, largest_velocity, or of a probe arrival_time:NAME, rise_rate:NAME, interval:NAME:NAME", "arrival_time:G-9"},
    {"observed", "measured", Takes::text, "", optional, "", "what the experiment says, in its words; a number (\"about 6300 s\", \"3 to 3.7 m\") is drawn, and what came out is told against it", "6300 s"},
    {"observed", "simulated", Takes::text, "", optional, "", "what a published simulation says, likewise; a [[tolerance]] on a quantity published_... gates what comes out against it", "6300 s"},
    {"observed", "remark", Takes::text, "", optional, "", "one sentence", "read off a figure"},
  };
}
// clang-format on

}  // namespace wetfront::verification
