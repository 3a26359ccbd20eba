#include "mpm/plan/check_numbers.h"

#include "mpm/plan/check_skeleton.h"
#include "mpm/plan/want.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

namespace {

struct RetentionCheck {
  const Soil& soil;
  void range(double s_min, double s_max) const {
    if (!(s_min >= 0)) refuse(soil.origin, "s_min of soil '" + soil.name + "'", s_min, "it has to be 0 or more");
    if (!(s_max > s_min && s_max <= 1))
      refuse(soil.origin, "s_max of soil '" + soil.name + "'", s_max, "it has to lie above s_min and not above 1");
  }
  void positive(const char* what, double value) const {
    want_positive(soil.origin, std::string(what) + " of soil '" + soil.name + "'", value);
  }
  void operator()(const VanGenuchtenRetention& r) const {
    range(r.s_min, r.s_max);
    positive("air entry", r.air_entry);
    want_between(soil.origin, "lambda of soil '" + soil.name + "'", r.lambda, 0, 1);
    if (!(r.cut_off >= 0)) refuse(soil.origin, "cut-off of soil '" + soil.name + "'", r.cut_off, "it is a suction");
  }
  void operator()(const ExponentialRetention& r) const {
    range(r.s_min, r.s_max);
    positive("suction scale", r.suction_scale);
  }
  void operator()(const HaverkampRetention& r) const {
    range(r.s_min, r.s_max);
    positive("a", r.a);
    positive("beta", r.beta);
  }
  void operator()(const HaverkampLogRetention& r) const {
    range(r.s_min, r.s_max);
    positive("a", r.a);
    positive("beta", r.beta);
    positive("entry", r.entry);
  }
  void operator()(const BroadbridgeWhiteRetention& r) const {
    range(r.s_min, r.s_max);
    positive("suction scale", r.suction_scale);
    if (!(r.c > 1)) refuse(soil.origin, "c of soil '" + soil.name + "'", r.c, "it has to exceed 1");
  }
  void operator()(const PointsRetention& r) const {
    for (double s : r.saturation) range(0, s);
  }
};

void check_soil(const Soil& soil, bool wet) {
  const std::string of = " of soil '" + soil.name + "'";
  want_between(soil.origin, "porosity" + of, soil.porosity, 0, 1);
  if (!wet) return;
  want_positive(soil.origin, "intrinsic permeability" + of, soil.intrinsic_permeability);
  if (soil.retention) std::visit(RetentionCheck{soil}, *soil.retention);
  if (soil.storage && !(*soil.storage >= 0)) refuse(soil.origin, "storage" + of, *soil.storage, "it is 0 or more");
}

void check_record(const Origin& origin, const std::string& what, const meshes::RainRecord& record, double least) {
  if (record.start.size() != record.intensity.size())
    refuse(origin, "length of the " + what + " record", static_cast<double>(record.intensity.size()),
           "it has " + std::to_string(record.start.size()) + " times");
  for (std::size_t k = 0; k < record.start.size(); ++k) {
    if (!std::isfinite(record.start[k]) || (k > 0 && !(record.start[k] > record.start[k - 1])))
      refuse(origin, "time " + std::to_string(k) + " of the " + what + " record", record.start[k],
             "times have to be finite and rise");
    if (!std::isfinite(record.intensity[k]) || record.intensity[k] < least)
      refuse(origin, "value " + std::to_string(k) + " of the " + what + " record", record.intensity[k],
             least == 0 ? "it has to be 0 or more" : "it has to be finite");
  }
}

struct BoundaryCheck {
  void operator()(const RainSide& b) const {
    check_record(b.origin, "rain", b.rain, 0);
    check_record(b.origin, "evaporation", b.evaporation, 0);
    if (!std::isfinite(b.least_pressure)) refuse(b.origin, "least pressure", b.least_pressure, "it has to be finite");
  }
  void operator()(const PressureSide& b) const {
    check_record(b.origin, "pressure", b.record);
    if (!std::isfinite(b.pressure)) refuse(b.origin, "prescribed pressure", b.pressure, "it has to be finite");
  }
  void operator()(const TotalHeadSide& b) const { check_record(b.origin, "head", b.head); }
  void operator()(const WaterLevelSide& b) const {
    check_record(b.origin, "level", b.level);
    check_record(b.origin, "rain", b.rain, 0);
  }
  void operator()(const FluxSide& b) const {
    check_record(b.origin, "inflow", b.inflow, -std::numeric_limits<double>::max());
    if (!std::isfinite(b.least_pressure)) refuse(b.origin, "least pressure", b.least_pressure, "it has to be finite");
  }
  void operator()(const FreeDrainageSide&) const {}
  void operator()(const PeriodicSides&) const {}
};

/// The Jacobian at every corner of every cell is positive.
template <int dim>
void check_cells(const meshes::Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.node_count(); ++i)
    for (double x : mesh.nodes[i])
      if (!std::isfinite(x)) refuse("", "a coordinate of mesh node " + std::to_string(i), x, "it has to be finite");
  if constexpr (dim == 2)
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
      const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(mesh.cells[4 * c + k % 4])]; };
      for (std::size_t k = 0; k < 4; ++k) {
        const auto a = at(k), b = at(k + 1), d = at(k + 3);
        const double turn = (b[0] - a[0]) * (d[1] - a[1]) - (d[0] - a[0]) * (b[1] - a[1]);
        if (!(turn > 0))
          refuse("", "twice the area at a corner of mesh cell " + std::to_string(c), turn,
                 "cells have to be convex, their nodes counter-clockwise");
      }
    }
}

}  // namespace

template <int dim>
void check_numbers(const Problem<dim>& problem) {
  check_cells<dim>(problem.mesh);
  for (const Soil& soil : problem.soils) check_soil(soil, problem.water.has_value());
  for (double g : problem.gravity)
    if (!std::isfinite(g)) refuse(problem.gravity_origin, "gravity", g, "it has to be finite");
  if (problem.water) {
    want_positive(problem.water->origin, "density of the water", problem.water->density);
    want_positive(problem.water->origin, "viscosity of the water", problem.water->viscosity);
    if (!(problem.water->bulk_modulus > 0))
      refuse(problem.water->origin, "bulk modulus of the water", problem.water->bulk_modulus,
             "it has to be positive; infinite for incompressible water");
  }
  for (std::size_t i = 0; i < problem.initial_pressure.size(); ++i)
    if (!std::isfinite(problem.initial_pressure[i]))
      refuse("", "the initial pressure at mesh node " + std::to_string(i), problem.initial_pressure[i],
             "it has to be finite");
  for (double factor : problem.conductivity_factor) want_positive("", "a conductivity factor", factor);
  for (const auto& boundary : problem.water_boundary) std::visit(BoundaryCheck{}, boundary);
  check_skeleton(problem);
  for (const Stage& stage : problem.stages) {
    want_positive(stage.origin, "end of stage '" + stage.name + "'", stage.end_time);
    want_positive(stage.origin, "time tolerance of stage '" + stage.name + "'", stage.time_tolerance);
    want_positive(stage.origin, "step_safety of stage '" + stage.name + "'", stage.step_safety);
  }
  if (!std::is_sorted(problem.output_times.begin(), problem.output_times.end()))
    throw CannotPlan("output times do not ascend. Sort them");
}

template void check_numbers(const Problem<2>&);
template void check_numbers(const Problem<3>&);

}  // namespace wetfront::mpm
