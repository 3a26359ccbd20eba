#include "verification/translate/reference_sides.h"

#include "verification/scene/weather.h"

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

const meshes::RainRecord dry{{0}, {0}};

fem::RainSide weather_side(const std::string& side, const Rain* rain, const Evaporation* evaporation,
                           double unit_weight) {
  fem::RainSide out{side, rain ? rain->record : dry};
  if (evaporation) {
    out.evaporation = evaporation->demand;
    out.minimum_head = evaporation->least_pressure / unit_weight;
  }
  return out;
}

fem::HeadSide head_side(const Boundary& boundary, double unit) {
  fem::HeadSide out{boundary.side, boundary.record.value.front() / unit};
  if (!boundary.record.constant()) {
    out.record = {boundary.record.time, boundary.record.value};
    for (double& value : out.record.value) value /= unit;
  }
  return out;
}

void add_boundary(const Scene& scene, const Boundary& boundary, double unit_weight,
                  std::vector<fem::BoundaryCondition>& sides) {
  switch (*boundary.water) {
    case WaterCondition::impermeable:
      return;
    case WaterCondition::free_drainage:
      sides.push_back(fem::FreeDrainageSide{boundary.side});
      return;
    case WaterCondition::pressure:
      if (boundary.record.value.empty())
        sides.push_back(fem::HeadSide{boundary.side, boundary.pressure / unit_weight});
      else
        sides.push_back(head_side(boundary, unit_weight));
      return;
    case WaterCondition::seepage_face:
      sides.push_back(fem::RainSide{boundary.side, dry});
      return;
    case WaterCondition::total_head: {
      fem::HeadSide side = head_side(boundary, 1);
      side.total = true;
      sides.push_back(side);
      return;
    }
    case WaterCondition::flux:
      sides.push_back(fem::FluxSide{boundary.side, boundary.inflow, boundary.least_pressure / unit_weight});
      return;
    case WaterCondition::water_level: {
      fem::WaterLevelSide side{boundary.side, {boundary.record.time, boundary.record.value}};
      if (const Rain* rain = rain_on(scene, boundary.side)) side.rain = rain->record;
      sides.push_back(side);
      return;
    }
    case WaterCondition::as_at_start: {
      fem::HeadSide side{boundary.side, 0};
      side.initial = true;
      sides.push_back(side);
      return;
    }
    case WaterCondition::periodic:
      sides.push_back(fem::PeriodicSides{boundary.side, boundary.partner});
  }
}

/// Value of a record at t = 0.
double at_start(const fem::TimeRecord& record) {
  double value = record.value.front();
  for (std::size_t i = 0; i < record.time.size() && record.time[i] <= 0; ++i) value = record.value[i];
  return value;
}

meshes::RainRecord held(const meshes::RainRecord& record) {
  return record.start.empty() ? record : meshes::RainRecord{{0}, {meshes::intensity_after(record, 0)}};
}

}  // namespace

std::vector<fem::BoundaryCondition> reference_sides(const Scene& scene, double unit_weight) {
  std::vector<fem::BoundaryCondition> sides;
  for (const Rain& rain : scene.rains)
    if (!under_water(scene, rain.side))
      sides.push_back(weather_side(rain.side, &rain, evaporation_from(scene, rain.side), unit_weight));
  for (const Evaporation& evaporation : scene.evaporations)
    if (!rain_on(scene, evaporation.side))
      sides.push_back(weather_side(evaporation.side, nullptr, &evaporation, unit_weight));
  for (const Boundary& boundary : scene.boundaries)
    if (boundary.water) add_boundary(scene, boundary, unit_weight, sides);
  return sides;
}

std::vector<fem::BoundaryCondition> antecedent_sides(const Scene& scene, double unit_weight,
                                                     const meshes::RainRecord& rain, bool evaporating) {
  std::vector<fem::BoundaryCondition> sides = reference_sides(scene, unit_weight);
  for (fem::BoundaryCondition& side : sides) {
    if (auto* sky = std::get_if<fem::RainSide>(&side)) {
      sky->rain = rain_on(scene, sky->side) ? rain : dry;
      sky->evaporation = evaporating ? held(sky->evaporation) : meshes::RainRecord{};
    }
    if (auto* water = std::get_if<fem::WaterLevelSide>(&side)) {
      if (!water->rain.start.empty()) water->rain = rain;
      water->level = {{0}, {at_start(water->level)}};
    }
    if (auto* head = std::get_if<fem::HeadSide>(&side); head && !head->record.time.empty()) {
      head->head = at_start(head->record);
      head->record = {};
    }
    if (auto* flux = std::get_if<fem::FluxSide>(&side)) flux->inflow = held(flux->inflow);
  }
  return sides;
}

}  // namespace wetfront::verification
