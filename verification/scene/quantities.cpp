#include "verification/scene/quantities.h"

namespace wetfront::verification {

const std::vector<Quantity>& quantities() {
  using Per = Quantity::Per;
  static const std::vector<Quantity> all = {
      {"pressure_l2", "1", Per::time, false, "pore pressure at cell centres, relative L2 against the reference"},
      {"pressure_l2_nodes", "1", Per::time, false, "the same at the nodes, where `seepage` has its unknowns"},
      {"pressure_l2_range", "1", Per::time, false,
       "root mean square of the difference over the range of the initial pressure"},
      {"pressure_one_mesh", "1", Per::time, false,
       "the same where both solvers have one mesh, whose error is in both: no bound of the reference is added"},
      {"pressure_finer", "1", Per::time, false, "the same against the reference on half the cell size, as it is"},
      {"pressure_linf", "1", Per::time, false,
       "pore pressure at cell centres, largest difference over largest reference value"},
      {"saturation_l2", "1", Per::time, false, "degree of saturation at cell centres, relative L2"},
      {"saturation_linf", "1", Per::time, false, "the same, largest difference over largest reference value"},
      {"front_position", "m", Per::time, false, "elevation of the wetting front"},
      {"cumulative_infiltration", "1", Per::time, false, "rain taken by the soil since the start"},
      {"side_inflow", "1", Per::time, false,
       "net inflow through each side since the start, largest difference over the largest inflow of the reference"},
      {"run_off", "1", Per::run, false, "rain refused until the end of the comparison, over the rain fallen"},
      {"outflow", "1", Per::run, false,
       "net water that left through all other sides by then, over the rain fallen; none: 0"},
      {"ponding_time", "1", Per::run, false, "when the soil first refuses rain"},
      {"filling_time", "1", Per::run, true, "when the soil is full, against storage deficit over rain"},
      {"arrival_time", "1", Per::probe, false, "when the pressure at a probe exceeds 0.2 kPa"},
      {"rise_rate", "1", Per::probe, false, "secant slope of the pressure at a probe between 0.2 and 4.9 kPa"},
      {"published_arrival_time", "1", Per::probe, false,
       "the same against what the scene's [[observed]] row says of a published simulation, as a number"},
      {"published_rise_rate", "1", Per::probe, false, "likewise"},
      {"published_interval", "1", Per::probe, false, "likewise, of the first of its two probes"},
      {"water_balance", "1", Per::run, false, "stored water against what went in and out, nodal sums", true},
      {"rain_asked", "1", Per::run, false, "the solver's own record of the rain against the scene's"},
      {"rain_delivered", "1", Per::run, false, "change of stored water plus outflow against rain asked less run-off"},
      {"reference_balance", "1", Per::run, false, "water balance of the reference"},
      {"overshoot", "Pa", Per::run, false, "largest pressure above the ponding limit at the surface"},
      {"energy_balance", "1", Per::run, false,
       "energy that a dynamically moving skeleton gains or loses unexplained, over the largest form of it", true},
      {"missed_events", "1", Per::run, false,
       "share of the events that stages are to end with (failure, rest) that did not come in their time", true},
      {"failure_time_mesh", "1", Per::run, false,
       "time of failure against that on the second mesh; 1 where it fails on one of the two alone", true},
      {"momentum_balance", "1", Per::run, false, "the same of momentum, over the largest of momentum and impulses",
       true},
  };
  return all;
}

const Quantity* find_quantity(const std::string& name) {
  for (const Quantity& quantity : quantities())
    if (quantity.name == name) return &quantity;
  return nullptr;
}

}  // namespace wetfront::verification
