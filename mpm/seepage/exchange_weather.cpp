#include "mpm/seepage/exchange_weather.h"

#include "mpm/boundary/time_record.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

double intensity(const meshes::RainRecord& record, double time) {
  return record.start.empty() ? 0 : meshes::intensity_after(record, time);
}

bool any_positive(const meshes::RainRecord& record) {
  return std::any_of(record.intensity.begin(), record.intensity.end(), [](double i) { return i > 0; });
}

}  // namespace

Weather weather_of(const WaterBoundary& condition, double begin) {
  if (const auto* rain = std::get_if<RainSide>(&condition))
    return {intensity(rain->rain, begin), intensity(rain->evaporation, begin), rain->least_pressure};
  if (const auto* level = std::get_if<WaterLevelSide>(&condition)) return {intensity(level->rain, begin), 0, 0};
  if (const auto* flux = std::get_if<FluxSide>(&condition)) {
    const double inflow = intensity(flux->inflow, begin);
    return {std::max(inflow, 0.0), std::max(-inflow, 0.0), flux->least_pressure};
  }
  return {};
}

bool exchanges(const WaterBoundary& condition) {
  return std::holds_alternative<RainSide>(condition) || std::holds_alternative<WaterLevelSide>(condition) ||
         std::holds_alternative<FluxSide>(condition);
}

bool wants_sky(const WaterBoundary& condition) {
  if (const auto* rain = std::get_if<RainSide>(&condition))
    return any_positive(rain->rain) || any_positive(rain->evaporation);
  if (const auto* level = std::get_if<WaterLevelSide>(&condition)) return any_positive(level->rain);
  return false;
}

std::vector<double> breaks_of(const WaterBoundary& condition) {
  std::vector<double> breaks;
  const auto add_steps = [&breaks](const meshes::RainRecord& record) {
    const auto more = meshes::changes(record);
    breaks.insert(breaks.end(), more.begin(), more.end());
  };
  const auto add_knots = [&breaks](const TimeRecord& record) {
    breaks.insert(breaks.end(), record.time.begin(), record.time.end());
  };
  if (const auto* rain = std::get_if<RainSide>(&condition)) {
    add_steps(rain->rain);
    add_steps(rain->evaporation);
  }
  if (const auto* flux = std::get_if<FluxSide>(&condition)) add_steps(flux->inflow);
  if (const auto* pressure = std::get_if<PressureSide>(&condition)) add_knots(pressure->record);
  if (const auto* head = std::get_if<TotalHeadSide>(&condition)) add_knots(head->head);
  if (const auto* level = std::get_if<WaterLevelSide>(&condition)) {
    add_steps(level->rain);
    add_knots(level->level);
  }
  return breaks;
}

void check_condition(const WaterBoundary& condition) {
  const auto* head = std::get_if<TotalHeadSide>(&condition);
  const auto* level = std::get_if<WaterLevelSide>(&condition);
  if ((head != nullptr && head->head.time.empty()) || (level != nullptr && level->level.time.empty()))
    throw CannotPlan(std::visit([](const auto& b) { return b.origin + ": side '" + b.side; }, condition) +
                     "' has a total head or a water level without a record of it. Give at least one value");
}

}  // namespace wetfront::mpm
