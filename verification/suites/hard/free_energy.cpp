#include "verification/suites/hard/free_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr int corners = 4;

double gravity_of(const mpm::Problem<2>& problem) {
  return std::hypot(problem.gravity[0], problem.gravity[1]);
}

/// Area of a quadrilateral cell [m2].
double area_of(const meshes::Mesh& mesh, std::size_t cell) {
  const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(mesh.cells[corners * cell + k])]; };
  const auto a = at(0), b = at(1), c = at(2), d = at(3);
  return 0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (d[0] - b[0]) * (c[1] - a[1]));
}

/// E of one snapshot [J/m].
double energy(const mpm::Problem<2>& problem, const meshes::Snapshot& shot) {
  const double weight = problem.water->density * gravity_of(problem);
  double sum = 0;
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const mpm::Soil& soil = problem.soils[static_cast<std::size_t>(problem.mesh.region[c])];
    const double pores = soil.porosity * area_of(problem.mesh, c);
    const auto content = [&](double p) { return water_content(soil, *problem.water, p); };
    if (shot.cells_hold_averages) {
      const double p = shot.cell_pressure[c];
      sum += pores * (weight * problem.mesh.cell_centre(c)[1] * content(p) + capillary_energy(soil, *problem.water, p));
      continue;
    }
    for (int k = 0; k < corners; ++k) {
      const auto node = static_cast<std::size_t>(problem.mesh.cells[corners * c + static_cast<std::size_t>(k)]);
      const double p = shot.node_pressure[node];
      sum += pores / corners *
             (weight * problem.mesh.nodes[node][1] * content(p) + capillary_energy(soil, *problem.water, p));
    }
  }
  return sum;
}

/// Energy per volume [Pa] that water takes with it through the sides other than the rained one; NaN: not one number.
double outflow_energy(const mpm::Problem<2>& problem, double surface) {
  double value = surface;  // a seepage face at the rained side: p = 0
  const double weight = problem.water->density * gravity_of(problem);
  for (const auto& boundary : problem.water_boundary) {
    if (const auto* rain = std::get_if<mpm::RainSide>(&boundary)) {
      if (!rain->evaporation.start.empty()) return not_known;
      continue;
    }
    const auto* held = std::get_if<mpm::PressureSide>(&boundary);
    if (held == nullptr || !held->record.time.empty() || held->initial) return not_known;
    const auto& side = problem.mesh.side(held->side);
    value = held->pressure + weight * problem.mesh.nodes[static_cast<std::size_t>(side.faces.front())][1];
  }
  return value;
}

}  // namespace

double saturation(const mpm::Soil& soil, double pressure) {
  const auto& curve = std::get<mpm::VanGenuchtenRetention>(*soil.retention);
  const auto effective = [&curve](double suction) {
    return std::pow(1 + std::pow(suction / curve.air_entry, 1 / (1 - curve.lambda)), -curve.lambda);
  };
  const double suction = -pressure;
  const double part = suction <= curve.cut_off ? 1 : effective(suction) / effective(curve.cut_off);
  return curve.s_min + (curve.s_max - curve.s_min) * part;
}

double water_content(const mpm::Soil& soil, const mpm::Water& water, double pressure) {
  return saturation(soil, pressure) * (1 + std::max(pressure, 0.0) / water.bulk_modulus);
}

double capillary_energy(const mpm::Soil& soil, const mpm::Water& water, double pressure) {
  const double full = saturation(soil, 0);
  if (pressure >= 0) return full * pressure * pressure / (2 * water.bulk_modulus);
  // integral of p dS = integral of S ds - s S(s), Simpson's rule in u = ln s.
  const double s = -pressure, low = std::log(std::min(1e-3, s)), high = std::log(s);
  constexpr int parts = 200;
  double sum = 0;
  const double step = (high - low) / parts;
  for (int k = 0; k <= parts; ++k) {
    const double x = std::exp(low + k * step);
    sum += (k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2) * x * saturation(soil, -x) * step / 3;
  }
  return full * std::exp(low) + sum - s * saturation(soil, -s);
}

double free_energy_growth(const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
  if (history.snapshots.empty() || !problem.surface.empty()) return not_known;  // cells are summed as full ones
  double top = -std::numeric_limits<double>::infinity();
  for (const auto& node : problem.mesh.nodes) top = std::max(top, node[1]);
  const double surface = problem.water->density * gravity_of(problem) * top;
  const double leaving = outflow_energy(problem, surface);
  if (std::isnan(leaving)) return not_known;
  meshes::Snapshot start = history.snapshots.front();
  const auto row_at = [&](double time) {
    return *std::find_if(history.ledger.begin(), history.ledger.end() - 1,
                         [time](const auto& row) { return row.time >= time; });
  };
  const double first = energy(problem, start);
  // Round-off of the sums themselves: where nothing moves, there is nothing to compare a gain with.
  const double noise = 1e-9 * surface * history.ledger.front().stored;
  double converted = 0, growth = 0;
  for (const auto& shot : history.snapshots) {
    const auto from = row_at(start.time), to = row_at(shot.time);
    const double work = surface * (to.infiltrated - from.infiltrated) - leaving * (to.outflow - from.outflow);
    const double gain = energy(problem, shot) - first - work;
    converted = std::max(converted, std::abs(work) + std::abs(gain));
    growth = std::isnan(gain) ? gain : std::max(growth, gain);
  }
  return growth / std::max(converted, noise);
}

}  // namespace wetfront::verification
