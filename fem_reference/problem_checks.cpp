#include "fem_reference/problem_checks.h"

#include "fem_reference/require.h"
#include "fem_reference/soil/soil_checks.h"
#include "fem_reference/soil/soil_law.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace wetfront::fem_reference {
namespace {

void check_rain(const meshes::RainRecord& rain, const std::string& where, bool either_sign = false) {
  require(rain.start.size() == rain.intensity.size(), where, ": ", rain.start.size(), " times for ",
          rain.intensity.size(), " intensities (one each)");
  for (std::size_t i = 0; i < rain.start.size(); ++i) {
    require(std::isfinite(rain.start[i]) && (i == 0 || rain.start[i] > rain.start[i - 1]), where, ".start[", i,
            "]: ", rain.start[i], " (times must ascend)");
    require(std::isfinite(rain.intensity[i]) && (either_sign || rain.intensity[i] >= 0), where, ".intensity[", i,
            "]: ", rain.intensity[i], either_sign ? " (not a number)" : " (must not be negative)");
  }
}

void check_record(const TimeRecord& record, const std::string& where) {
  require(record.time.size() == record.value.size(), where, ": ", record.time.size(), " times for ",
          record.value.size(), " values (one each)");
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    require(std::isfinite(record.time[i]) && (i == 0 || record.time[i] >= record.time[i - 1]), where, ".time[", i,
            "]: ", record.time[i], " (times must not fall)");
    require(std::isfinite(record.value[i]), where, ".value[", i, "]: not a number");
  }
}

void check_condition(const RainSide& rain, const std::string& where) {
  check_rain(rain.rain, where + ".rain");
  check_rain(rain.evaporation, where + ".evaporation");
  require(rain.minimum_head < 0, where, ".minimum_head: ", rain.minimum_head, " (must be negative, in m)");
}
void check_condition(const FluxSide& flux, const std::string& where) {
  check_rain(flux.inflow, where + ".inflow", true);
  require(flux.minimum_head < 0, where, ".minimum_head: ", flux.minimum_head, " (must be negative, in m)");
}
void check_condition(const HeadSide& head, const std::string& where) {
  require(std::isfinite(head.head), where, ".head: not a number");
  check_record(head.record, where + ".record");
  require(!head.varying || (head.record.time.empty() && !head.total && !head.initial), where,
          ".varying: says the head itself, so there is neither a record, a total head nor an initial one");
  require(!head.initial || (head.record.time.empty() && !head.total), where,
          ".initial: keeps the initial heads, so there is neither a record nor a total head");
}
void check_condition(const WaterLevelSide& level, const std::string& where) {
  require(!level.level.time.empty(), where, ".level: empty (at least one entry)");
  check_record(level.level, where + ".level");
  check_rain(level.rain, where + ".rain");
}
void check_condition(const FreeDrainageSide&, const std::string&) {}
void check_condition(const PeriodicSides&, const std::string&) {}

void check_boundary(const RichardsProblem& problem) {
  const auto& sides = problem.mesh.sides;
  std::string known;
  for (const meshes::Side& s : sides) known += (known.empty() ? "" : ", ") + s.name;
  std::set<std::string> seen;
  const auto take_side = [&](const std::string& side, const std::string& where) {
    require(std::any_of(sides.begin(), sides.end(), [&](const meshes::Side& s) { return s.name == side; }), where,
            ": the mesh has no such side (it has: ", known, ")");
    require(seen.insert(side).second, where, ": a second condition on this side (one each)");
  };
  for (std::size_t b = 0; b < problem.boundary.size(); ++b) {
    const BoundaryCondition& condition = problem.boundary[b];
    const std::string& side = std::visit([](const auto& c) -> const std::string& { return c.side; }, condition);
    const std::string where = entry("boundary", b) + " '" + side + "'";
    take_side(side, where);
    if (const auto* pair = std::get_if<PeriodicSides>(&condition)) {
      take_side(pair->partner, where + ".partner '" + pair->partner + "'");
    }
    std::visit([&](const auto& c) { check_condition(c, where); }, condition);
  }
}

void check_times(const RichardsProblem& problem) {
  require(positive(problem.end_time), "end_time: ", problem.end_time, " (must be positive, in s)");
  double last = 0;
  for (std::size_t i = 0; i < problem.output_times.size(); ++i) {
    const double t = problem.output_times[i];
    require(t >= last && t <= problem.end_time, entry("output_times", i), ": ", t,
            " (must ascend and lie within [0, end_time = ", problem.end_time, "])");
    last = t;
  }
}

void check_conductivity_factor(const RichardsProblem& problem) {
  const std::vector<double>& factor = problem.conductivity_factor;
  require(factor.empty() || factor.size() == problem.mesh.cell_count(), "conductivity_factor: ", factor.size(),
          " values (the mesh has ", problem.mesh.cell_count(), " cells)");
  for (std::size_t c = 0; c < factor.size(); ++c) {
    require(positive(factor[c]), entry("conductivity_factor", c), ": ", factor[c], " (must be positive)");
  }
}

/// The driest head that the problem speaks of [m].
double driest_head(const RichardsProblem& problem) {
  double driest = *std::min_element(problem.initial_head.begin(), problem.initial_head.end());
  const auto demands = [](const meshes::RainRecord& record, double sign) {
    return std::any_of(record.intensity.begin(), record.intensity.end(), [&](double q) { return sign * q > 0; });
  };
  for (const BoundaryCondition& condition : problem.boundary) {
    if (const auto* head = std::get_if<HeadSide>(&condition)) {
      if (!head->total && head->record.time.empty()) driest = std::min(driest, head->head);
      for (double h : head->record.value) driest = std::min(driest, head->total ? driest : h);
    }
    if (const auto* rain = std::get_if<RainSide>(&condition); rain != nullptr && demands(rain->evaporation, 1)) {
      driest = std::min(driest, rain->minimum_head);
    }
    if (const auto* flux = std::get_if<FluxSide>(&condition); flux != nullptr && demands(flux->inflow, -1)) {
      driest = std::min(driest, flux->minimum_head);
    }
  }
  return driest;
}

/// Under an elastic skeleton W must rise with the head wherever the heads of the problem go.
void check_skeleton(const RichardsProblem& problem) {
  for (std::size_t s = 0; s < problem.soils.size(); ++s) {
    const Soil& soil = problem.soils[s];
    if (soil.oedometer_modulus == 0) continue;
    const double limit = SoilLaw(soil, problem.unit_weight).skeleton_limit(), driest = driest_head(problem);
    require(limit < driest, entry("soils", s), " '", soil.name, "'.oedometer_modulus: ", soil.oedometer_modulus,
            " Pa: below a head of ", limit,
            " m this skeleton gives off more water than the pores take up as the soil"
            " wets (chi + p dchi/dp is negative there), and the problem's driest head is ",
            driest, " m");
  }
}

void check_gravity(const RichardsProblem& problem) {
  double square = 0;
  for (int axis = 0; axis < problem.mesh.dim; ++axis) {
    square += problem.gravity_direction[axis] * problem.gravity_direction[axis];
  }
  // Zero switches gravity off (horizontal infiltration); anything else must be a unit vector.
  require(square == 0 || std::abs(square - 1) < 1e-9, "gravity_direction: length ", std::sqrt(square),
          " (must be a unit vector, or zero for no gravity)");
}

void check_adaptivity(const RichardsProblem& problem) {
  if (!problem.adaptivity) return;
  const auto& [levels, threshold] = *problem.adaptivity;
  require(levels >= 0 && levels <= 8, "adaptivity.levels: ", levels, " (0 to 8 halvings)");
  require(threshold >= 0 && std::isfinite(threshold), "adaptivity.threshold: ", threshold,
          " (a water content, not negative)");
  require(problem.degree == 1, "adaptivity: hanging nodes are written for linear elements (degree is ", problem.degree,
          ")");
  for (std::size_t b = 0; b < problem.boundary.size(); ++b) {
    require(!std::holds_alternative<PeriodicSides>(problem.boundary[b]), entry("boundary", b),
            ": periodic sides and adaptivity exclude each other (partners would have to be halved alike)");
  }
}

}  // namespace

void check_problem(const RichardsProblem& problem) {
  require(problem.mesh.dim >= 1 && problem.mesh.dim <= 3, "mesh.dim: ", problem.mesh.dim, " (must be 1, 2 or 3)");
  require(problem.mesh.cell_count() > 0, "mesh: no cells");
  meshes::validate(problem.mesh);
  check_gravity(problem);
  check_soils(problem);
  check_boundary(problem);
  check_times(problem);
  require(positive(problem.unit_weight), "unit_weight: ", problem.unit_weight, " (must be positive, in Pa/m)");
  require(problem.initial_head.size() == problem.mesh.node_count(), "initial_head: ", problem.initial_head.size(),
          " values (the mesh has ", problem.mesh.node_count(), " nodes)");
  for (std::size_t i = 0; i < problem.initial_head.size(); ++i) {
    require(std::isfinite(problem.initial_head[i]), entry("initial_head", i), ": not a number");
  }
  check_conductivity_factor(problem);
  check_skeleton(problem);
  require(problem.tolerance > 0 && problem.tolerance <= 0.1, "tolerance: ", problem.tolerance,
          " (must lie in (0, 0.1])");
  require(problem.degree >= 1 && problem.degree <= 4, "degree: ", problem.degree, " (1 to 4)");
  check_adaptivity(problem);
}

}  // namespace wetfront::fem_reference
