#include "verification/present/tables.h"

#include "verification/compare/events.h"
#include "verification/present/scene_text.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

using reports::Table;

std::string rain_text(const Rain& rain) {
  if (rain.record.start.size() > 1)
    return fmt::format("on '{}', a record of {} intensities", rain.side, rain.record.start.size());
  const double intensity = rain.record.intensity.front();
  return fmt::format("on '{}', {:.4g} m/s ({:.4g} mm/h)", rain.side, intensity, intensity * 3.6e6);
}

/// How long a stage lasts; `end` counts from the start of the run [s].
std::string stage_text(const Stage& stage, double end) {
  std::string text = stage.lasts ? fmt::format("lasts {:.6g} s", *stage.lasts) : fmt::format("until {:.6g} s", end);
  if (stage.event.kind == StageEvent::Kind::none) return text;
  text += stage.lasts ? " at most" : " at the latest";
  return text + (stage.event.kind == StageEvent::Kind::failure ? ", ends with failure" : ", ends with rest");
}

void add_soil(Table& table, const Soil& soil, const Scene& scene) {
  table.rows.push_back(
      {"soil '" + soil.name + "'", fmt::format("porosity {:g}, grains {:g} kg/m3, intrinsic permeability {:.4g} m2",
                                               soil.porosity, soil.grain_density, soil.intrinsic_permeability)});
  if (scene.water) {
    const double conductivity =
        soil.intrinsic_permeability * scene.water->density * gravity_magnitude(scene) / scene.water->viscosity;
    table.rows.push_back({"saturated conductivity", fmt::format("{:.4g} m/s", conductivity)});
  }
  if (soil.retention) {
    table.rows.push_back({"retention", retention_text(*soil.retention)});
    table.rows.push_back({"relative permeability", permeability_text(soil)});
  }
  if (soil.anisotropy)
    table.rows.push_back(
        {"anisotropy", fmt::format("{:g} along, {:g} across, bedding at {:g} degrees", soil.anisotropy->along,
                                   soil.anisotropy->across, soil.anisotropy->angle * 180 / M_PI)});
  if (soil.conductivity_field)
    table.rows.push_back({"conductivity field", fmt::format("{} places", soil.conductivity_field->value.size())});
  if (soil.strength) table.rows.push_back({"strength", strength_text(*soil.strength)});
  table.rows.push_back({"skeleton", soil.elastic ? fmt::format("elastic, E {:g} MPa, nu {:g}",
                                                               soil.elastic->young / 1e6, soil.elastic->poisson)
                                                 : "rigid"});
}

}  // namespace

Table cost_table(const std::string& who, const meshes::FieldHistory& history) {
  Table table;
  table.title = "Cost of the " + who;
  table.section = "Cost";
  table.header = {"phase", "kernel", "CPU [s]", "share [%]", "calls"};
  for (const auto& cost : history.cost)
    table.rows.push_back({cost.phase, cost.kernel, fmt::format("{:.4f}", cost.cpu_seconds),
                          fmt::format("{:.1f}", 100 * cost.cpu_seconds / std::max(history.cpu_seconds, 1e-12)),
                          std::to_string(cost.calls)});
  table.rows.push_back({"", "total", fmt::format("{:.4f}", history.cpu_seconds), "100", ""});
  table.caption = history.solver;
  for (const auto& [name, value] : history.counters) table.caption += fmt::format("; {} {:g}", name, value);
  return table;
}

std::vector<double> audit_times(const meshes::FieldHistory& history, const Timeline& timeline) {
  std::vector<double> times = timeline.comparison_times;
  const double end = std::min(history.ledger.back().time, timeline.end());
  std::erase_if(times, [end](double time) { return time >= end * (1 - 1e-12); });
  times.push_back(end);
  std::ranges::sort(times);
  return times;
}

Table ledger_table(const std::string& who, const meshes::FieldHistory& history, double area, const Timeline& timeline) {
  Table table;
  table.title = "Water ledger of the " + who;
  table.section = "Flux audit";
  table.caption = "Delivered is the change of stored water plus outflow: it does not use the boundary code.";
  table.header = {"time [s]",     "rain asked [mm]", "imposed [mm]",          "run off [mm]",
                  "outflow [mm]", "stored [mm]",     "delivered, nodal [mm]", "delivered, particles [mm]"};
  if (history.ledger.empty()) return table;
  using Row = meshes::LedgerRow;
  for (const double time : audit_times(history, timeline)) {
    const auto mm = [&](double Row::*column) { return 1000 * ledger_at(history.ledger, column, time) / area; };
    const auto since_start = [&](double Row::*column) {
      return mm(column) - 1000 * (history.ledger.front().*column) / area;
    };
    const double points = since_start(&Row::stored_points) + mm(&Row::outflow);
    table.rows.push_back({fmt::format("{:.6g}", time), fmt::format("{:.4f}", mm(&Row::rain_asked)),
                          fmt::format("{:.4f}", mm(&Row::infiltrated)), fmt::format("{:.4f}", mm(&Row::run_off)),
                          fmt::format("{:.4f}", mm(&Row::outflow)), fmt::format("{:.4f}", mm(&Row::stored)),
                          fmt::format("{:.6f}", since_start(&Row::stored) + mm(&Row::outflow)),
                          std::isnan(points) ? "-" : fmt::format("{:.6f}", points)});
  }
  return table;
}

Table node_rain_table(const meshes::FieldHistory& history) {
  Table table;
  table.title = "Rain over each boundary node at the end of the run";
  table.section = "Flux audit";
  table.header = {"node", "x [m]", "y [m]", "asked [l/m]", "imposed [l/m]", "run off [l/m]"};
  for (const auto& node : history.rain_by_node)
    table.rows.push_back({std::to_string(node.node), fmt::format("{:.4g}", node.position[0]),
                          fmt::format("{:.4g}", node.position[1]), fmt::format("{:.6f}", 1000 * node.asked),
                          fmt::format("{:.6f}", 1000 * node.imposed), fmt::format("{:.6f}", 1000 * node.run_off)});
  return table;
}

Table setup_table(const Scene& scene, const Timeline& timeline) {
  Table table;
  table.title = "Set-up";
  table.section = "Set-up";
  table.header = {"what", "value"};
  table.rows.push_back({"geometry", geometry_text(scene.geometry)});
  for (const Soil& soil : scene.soils) add_soil(table, soil, scene);
  if (scene.water)
    table.rows.push_back(
        {"water", fmt::format("{:g} kg/m3, bulk modulus {:g} GPa, viscosity {:g} Pa s", scene.water->density,
                              scene.water->bulk_modulus / 1e9, scene.water->viscosity)});
  if (scene.mpm.water_softening < 1)
    table.rows.push_back({"water of the MPM", fmt::format("softened: {:g} of that bulk modulus, for longer steps",
                                                          scene.mpm.water_softening)});
  if (scene.initial) table.rows.push_back({"initial state", start_text(*scene.initial)});
  for (const Layer& layer : scene.geometry.layers) table.rows.push_back({"layer", layer_text(layer)});
  for (const Zone& zone : scene.geometry.zones)
    table.rows.push_back({"zone of '" + zone.soil + "'", extent_text(zone.extent)});
  for (const SidePart& part : scene.geometry.parts)
    table.rows.push_back({"'" + part.name + "', part of '" + part.of + "'", extent_text(part.extent)});
  for (const Rain& rain : scene.rains) table.rows.push_back({"rain", rain_text(rain)});
  for (const Evaporation& evaporation : scene.evaporations)
    table.rows.push_back({"evaporation", evaporation_text(evaporation)});
  for (const Boundary& boundary : scene.boundaries)
    if (boundary.water) table.rows.push_back({"water at '" + boundary.side + "'", boundary_text(boundary)});
  for (const Boundary& boundary : scene.boundaries)
    if (const std::string text = skeleton_side_text(boundary); !text.empty())
      table.rows.push_back({"skeleton at '" + boundary.side + "'", text});
  if (deforms(scene)) table.rows.push_back({"skeleton", skeleton_text(scene.skeleton)});
  if (timeline.filling_time)
    table.rows.push_back({"filling time", fmt::format("{:.6g} s (storage deficit / rain)", *timeline.filling_time)});
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    table.rows.push_back({"stage '" + scene.stages[i].name + "'", stage_text(scene.stages[i], timeline.stage_end[i])});
  table.rows.push_back({"points per cell", std::to_string(scene.mpm.points_per_cell)});
  if (scene.reference)
    table.rows.push_back({"reference", fmt::format("{} cells, tolerance {:g}; its error from cells twice and half as "
                                                   "large and from tolerance {:g}",
                                                   scene.reference->cells, scene.reference->tolerance,
                                                   scene.reference->tolerance / 10)});
  return table;
}

}  // namespace wetfront::verification
