#pragma once

#include "meshes/field_history.h"

#include <nlohmann/json.hpp>

/// FieldHistory as JSON, in files of this program only.
namespace wetfront::meshes {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Side, name, faces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mesh, dim, nodes, cells, region, region_names, sides)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PointCloud, position, pressure, saturation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Snapshot, time, stage, node_pressure, node_saturation, cell_pressure,
                                   cell_saturation, cells_hold_averages, points, node_displacement)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LedgerRow, time, rain_asked, infiltrated, run_off, outflow, stored, stored_points)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SideLedger, side, condition, asked, run_off, outflow, evaporated, demanded)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionRow, time, kinetic, potential, stress_work, load_work, resistance, drift,
                                   motion, momentum, impulse, reaction, momentum_drift)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Gauge, name, position, time, pressure, saturation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NodeRain, node, position, asked, imposed, run_off)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(KernelCost, phase, kernel, cpu_seconds, calls)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FieldHistory, solver, mesh, snapshots, ledger, sides, motion, gauges, rain_by_node,
                                   cost, cpu_seconds, counters, log)

// A member that is not written would come back empty; these do not compile when one is added.
namespace {
[[maybe_unused]] void every_member_is_written(const FieldHistory& history) {
  [[maybe_unused]] const auto& [solver, mesh, snapshots, ledger, sides, motions, gauges, rain, cost, cpu, counters,
                                log] = history;
  [[maybe_unused]] const auto& [time, stage, np, ns, cp, cs, averages, points, displacement] = snapshots[0];
  [[maybe_unused]] const auto& [t, asked, infiltrated, run_off, outflow, stored, stored_points] = ledger[0];
  [[maybe_unused]] const auto& [side, condition, a, r, o, e, d] = sides[0];
  [[maybe_unused]] const auto& [when, kinetic, potential, stress, load, resistance, drift, motion, momentum, impulse,
                                reaction, momentum_drift] = motions[0];
  [[maybe_unused]] const auto& [gauge, position, times, pressure, saturation] = gauges[0];
  [[maybe_unused]] const auto& [node, place, all, imposed, off] = rain[0];
}
}  // namespace

}  // namespace wetfront::meshes
