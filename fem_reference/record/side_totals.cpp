#include "fem_reference/record/side_totals.h"

namespace wetfront::fem_reference {
namespace {

struct KindOf {
  const char* operator()(const RainSide&) const { return "rain"; }
  const char* operator()(const HeadSide&) const { return "head"; }
  const char* operator()(const FreeDrainageSide&) const { return "free drainage"; }
  const char* operator()(const FluxSide&) const { return "flux"; }
  const char* operator()(const WaterLevelSide&) const { return "water level"; }
  const char* operator()(const PeriodicSides&) const { return "periodic"; }
};

}  // namespace

SideTotals::SideTotals(const RichardsProblem& problem) : problem_(problem), sums_(problem.boundary.size() + 2) {
  const std::size_t conditions = problem.boundary.size();
  for (std::size_t c = 0; c < conditions; ++c) {
    const BoundaryCondition& condition = problem.boundary[c];
    if (std::holds_alternative<PeriodicSides>(condition)) continue;
    shown_.push_back({c, std::visit([](const auto& s) { return s.side; }, condition), std::visit(KindOf{}, condition)});
  }
  if (problem.source) shown_.push_back({conditions, "", "source"});
  if (problem.adaptivity) shown_.push_back({conditions + 1, "", "adapting the mesh"});
}

void SideTotals::attach(const Boundary& boundary, const Ranks& ranks, const State& state) {
  boundary_ = &boundary;
  ranks_ = ranks;
  time_ = state.time;
  last_ = state.totals;
}

void SideTotals::advance(const State& state) {
  const std::vector<HeldDof>& held = boundary_->held();
  const std::size_t conditions = problem_.boundary.size(), unmet = held.size() + conditions;
  const auto grown = [&](std::size_t i) { return state.totals[i] - last_[i]; };
  for (std::size_t h = 0; h < held.size(); ++h) {
    advance_dof(held[h], state.time - time_, grown(h), boundary_->has_demand() ? grown(unmet + h) : 0);
  }
  for (std::size_t c = 0; c < conditions; ++c) sums_[c].outflow += grown(held.size() + c);
  if (problem_.source) sums_[conditions].outflow -= grown(state.totals.size() - 1);
  time_ = state.time;
  last_ = state.totals;
}

void SideTotals::advance_dof(const HeldDof& held, double span, double run_off, double unmet) {
  for (const HeldDof::Catchment& catchment : held.catchment) {
    Sums& sums = sums_[catchment.condition];
    sums.asked += span * catchment.rain;
    sums.demanded += span * catchment.demand;
    if (held.rain > 0) sums.run_off += run_off * (catchment.rain / held.rain);
    if (held.demand > 0) sums.evaporated += span * catchment.demand - unmet * (catchment.demand / held.demand);
  }
}

std::vector<SideTotals::Sums> SideTotals::of_all_ranks() const {
  std::vector<double> values;
  for (const Sums& s : sums_) values.insert(values.end(), {s.asked, s.run_off, s.outflow, s.evaporated, s.demanded});
  ranks_.sum(values);
  std::vector<Sums> all;
  for (std::size_t i = 0; i < values.size(); i += 5) {
    all.push_back({values[i], values[i + 1], values[i + 2], values[i + 3], values[i + 4]});
  }
  return all;
}

meshes::LedgerRow SideTotals::row() const {
  meshes::LedgerRow row;
  for (const Sums& sums : of_all_ranks()) {
    row.rain_asked += sums.asked;
    row.run_off += sums.run_off;
    row.outflow += sums.outflow + sums.evaporated;
  }
  row.infiltrated = row.rain_asked - row.run_off;
  return row;
}

void SideTotals::append_to(std::vector<meshes::SideLedger>& sides) const {
  if (sides.empty()) {
    for (const Entry& entry : shown_) {
      sides.emplace_back();
      sides.back().side = entry.side;
      sides.back().condition = entry.condition;
    }
  }
  const std::vector<Sums> all = of_all_ranks();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const Sums& sums = all[shown_[i].index];
    sides[i].asked.push_back(sums.asked);
    sides[i].run_off.push_back(sums.run_off);
    sides[i].outflow.push_back(sums.outflow);
    sides[i].evaporated.push_back(sums.evaporated);
    sides[i].demanded.push_back(sums.demanded);
  }
}

}  // namespace wetfront::fem_reference
