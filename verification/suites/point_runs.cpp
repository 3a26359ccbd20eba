#include "verification/suites/point_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace wetfront::verification {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// All that passed a side, step by step in either direction; where the scheme keeps no sides apart, rain and the rest.
double water_passed(const meshes::FieldHistory& history) {
  double passed = 0;
  for (const meshes::SideLedger& side : history.sides)
    for (std::size_t i = 1; i < side.outflow.size(); ++i)
      passed += std::abs(side.asked[i] - side.run_off[i] - side.asked[i - 1] + side.run_off[i - 1]) +
                std::abs(side.outflow[i] - side.outflow[i - 1]) + std::abs(side.evaporated[i] - side.evaporated[i - 1]);
  if (passed > 0) return passed;
  const auto& ledger = history.ledger;
  for (std::size_t i = 1; i < ledger.size(); ++i)
    passed += std::abs(ledger[i].infiltrated - ledger[i - 1].infiltrated) +
              std::abs(ledger[i].outflow - ledger[i - 1].outflow);
  return passed;
}

/// The larger of two, infinity where one is no number.
double larger(double so_far, double value) {
  return std::isfinite(value) ? std::max(so_far, value) : infinite;
}

/// What the pore pressure may at most be.
class Ceiling {
 public:
  explicit Ceiling(const mpm::Problem<2>& problem)
      : mesh_(problem.mesh), weight_(problem.water->density * std::hypot(problem.gravity[0], problem.gravity[1])) {
    for (std::size_t i = 0; i < mesh_.node_count(); ++i)
      raise(problem.initial_pressure[i] + weight_ * mesh_.nodes[i][1]);
    for (const auto& side : problem.water_boundary) std::visit([&](const auto& s) { add(s); }, side);
    if (!problem.surface.empty())
      for (const auto& at : problem.surface) raise(weight_ * at[1]);
  }

  double at_node(std::size_t node) const {
    const double below = total_ - weight_ * mesh_.nodes[node][1];
    return rained_.contains(static_cast<int>(node)) ? std::min(0.0, below) : below;
  }
  double at(const meshes::Point& place) const {
    for (const int node : rained_)
      if (std::hypot(place[0] - mesh_.nodes[node][0], place[1] - mesh_.nodes[node][1]) < 1e-9) return at_node(node);
    return total_ - weight_ * place[1];
  }

 private:
  void raise(double total) { total_ = std::max(total_, total); }
  /// Rain: no deeper than p = 0 at the surface.
  void add_weather(const std::string& side) {
    if (side == mpm::free_surface) return;
    for (const int node : mesh_.side(side).faces) {
      raise(weight_ * mesh_.nodes[node][1]);
      rained_.insert(node);
    }
  }
  void add(const mpm::RainSide& s) { add_weather(s.side); }
  void add(const mpm::FluxSide& s) { add_weather(s.side); }
  void add(const mpm::PressureSide& s) {
    if (s.initial) return;
    for (const int node : mesh_.side(s.side).faces) {
      raise(s.pressure + weight_ * mesh_.nodes[node][1]);
      for (const double p : s.record.value) raise(p + weight_ * mesh_.nodes[node][1]);
    }
  }
  void add(const mpm::TotalHeadSide& s) {
    for (const double head : s.head.value) raise(weight_ * head);
  }
  void add(const mpm::WaterLevelSide& s) {
    for (const double level : s.level.value) raise(weight_ * level);
    if (!s.rain.start.empty())
      for (const int node : mesh_.side(s.side).faces) raise(weight_ * mesh_.nodes[node][1]);
  }
  void add(const mpm::FreeDrainageSide&) {}
  void add(const mpm::PeriodicSides&) {}

  const meshes::Mesh& mesh_;
  double weight_;             ///< rho g [Pa/m]
  double total_ = -infinite;  ///< rho g H [Pa]
  std::set<int> rained_;
};

}  // namespace

WaterAudit audit(const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
  WaterAudit found;
  const auto& first = history.ledger.front();
  for (const auto& row : history.ledger) {
    const double taken = row.rain_asked - row.run_off - row.outflow;
    found.nodes = larger(found.nodes, std::abs(row.stored - first.stored - taken));
    found.points = larger(found.points, std::abs(row.stored_points - first.stored_points - taken));
  }
  const double passed = water_passed(history);
  found.nodes /= passed > 0 ? passed : first.stored;
  found.points /= passed > 0 ? passed : first.stored;
  const Ceiling ceiling(problem);
  for (const auto& snapshot : history.snapshots)
    for (std::size_t i = 0; i < snapshot.node_pressure.size(); ++i)
      if (!problem.surface.empty() && std::isnan(snapshot.node_pressure[i]))
        continue;  // no soil there
      else
        found.overshoot = larger(found.overshoot, snapshot.node_pressure[i] - ceiling.at_node(i));
  for (const auto& gauge : history.gauges)
    for (const double p : gauge.pressure) found.overshoot = larger(found.overshoot, p - ceiling.at(gauge.position));
  return found;
}

PointRuns::PointRuns()
    : table_{
          "Runs of the material point method",
          "Cost",
          "One row per solution. Water missing: rain asked - run-off - what is found in the soil and what left it, "
          "relative to all that passed the sides; from what the scheme conserves, and summed over the points.",
          {"run", "points", "steps", "Newton", "rejected", "CPU [s]", "missing", "missing (points)", "overshoot [Pa]"},
          {}} {}

void PointRuns::enter(const std::string& label, const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
  const WaterAudit found = audit(problem, history);
  const bool seeps = std::ranges::all_of(
      problem.stages, [](const mpm::Stage& stage) { return stage.liquid == mpm::LiquidScheme::seepage; });
  Worst& worst = seeps ? seepage_ : two_velocities_;
  ++worst.runs;
  worst.audit.nodes = larger(worst.audit.nodes, found.nodes);
  worst.audit.points = larger(worst.audit.points, found.points);
  worst.audit.overshoot = larger(worst.audit.overshoot, found.overshoot);
  const auto count = [&](const char* name) {
    const auto at = history.counters.find(name);
    return fmt::format("{:g}", at == history.counters.end() ? 0 : at->second);
  };
  const std::size_t points = history.snapshots.empty() ? 0 : history.snapshots.back().points.pressure.size();
  table_.rows.push_back({label, fmt::format("{}", points), count("steps"), count("Newton iterations"),
                         count("rejected steps"), fmt::format("{:.3f}", history.cpu_seconds),
                         fmt::format("{:.1e}", found.nodes), fmt::format("{:.1e}", found.points),
                         fmt::format("{:.2g}", found.overshoot)});
}

}  // namespace wetfront::verification
