#include "mpm/record/side_totals.h"

namespace wetfront::mpm {

namespace {

struct KindOf {
  const char* operator()(const RainSide&) const { return "rain"; }
  const char* operator()(const PressureSide&) const { return "head"; }
  const char* operator()(const TotalHeadSide&) const { return "head"; }
  const char* operator()(const FreeDrainageSide&) const { return "free drainage"; }
  const char* operator()(const WaterLevelSide&) const { return "water level"; }
  const char* operator()(const FluxSide&) const { return "flux"; }
  const char* operator()(const PeriodicSides&) const { return "periodic"; }
};

}  // namespace

template <int dim>
void record_sides(StagePlan<dim>& plan, const Column& totals) {
  plan.at_record([&plan, &totals](double, meshes::FieldHistory& history) {
    const auto& conditions = plan.problem.water_boundary;
    std::size_t entry = 0;
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      if (std::holds_alternative<PeriodicSides>(conditions[c])) continue;
      if (history.sides.size() == entry) {
        meshes::SideLedger fresh;
        fresh.side = std::visit([](const auto& b) { return b.side; }, conditions[c]);
        fresh.condition = std::visit(KindOf{}, conditions[c]);
        history.sides.push_back(std::move(fresh));
      }
      meshes::SideLedger& side = history.sides[entry++];
      const auto total = [&](SideEntry e) { return totals[side_component(static_cast<int>(c), e)][0]; };
      side.asked.push_back(total(side_asked));
      side.run_off.push_back(total(side_run_off));
      side.outflow.push_back(total(side_outflow));
      side.evaporated.push_back(total(side_evaporated));
      side.demanded.push_back(total(side_demanded));
    }
  });
}

template void record_sides(StagePlan<2>&, const Column&);
template void record_sides(StagePlan<3>&, const Column&);

}  // namespace wetfront::mpm
