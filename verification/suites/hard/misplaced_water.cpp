// How a column's water is compared with the reference's.
#include "verification/suites/hard/free_energy.h"
#include "verification/suites/hard/hard_column.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace wetfront::verification {
namespace {

/// Elevation and content of the pieces of a column, from the base upwards: half cells or cells.
struct Piece {
  double from, to;  ///< m
  double water;     ///< m3/m2
};

std::vector<Piece> pieces(const HardColumn& column, const meshes::Mesh& mesh, const meshes::Snapshot& shot) {
  const mpm::Problem<2> laws = strip_problem(column);
  const auto up = static_cast<std::size_t>(meshes::up_axis(mesh.dim));
  const std::size_t width = mesh.dim == 1 ? 1 : 2;  // nodes per elevation
  const double surface = column.surface > 0 ? column.surface : column.height;
  std::vector<Piece> out;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const double low = mesh.nodes[width * c][up], high = mesh.nodes[width * (c + 1)][up];
    const mpm::Soil& soil = laws.soils[static_cast<std::size_t>(mesh.region[c])];
    const auto content = [&](double p) { return soil.porosity * water_content(soil, *laws.water, p); };
    const double top = std::min(high, surface);
    if (top <= low) continue;
    if (shot.cells_hold_averages) {
      out.push_back({low, top, content(shot.cell_pressure[c]) * (top - low)});
      continue;
    }
    // Lumped: each node stands for the part of the soil that its shape function has.
    const double upper = (top - low) * (top - low) / (2 * (high - low)), lower = top - low - upper;
    out.push_back({low, low + lower, content(shot.node_pressure[width * c]) * lower});
    out.push_back({low + lower, top, content(shot.node_pressure[width * (c + 1)]) * upper});
  }
  return out;
}

std::vector<double> below(const std::vector<Piece>& pieces, const std::vector<double>& elevations) {
  std::vector<double> sums;
  for (const double z : elevations) {
    double sum = 0;
    for (const Piece& piece : pieces)
      sum += piece.water * std::clamp((z - piece.from) / (piece.to - piece.from), 0.0, 1.0);
    sums.push_back(sum);
  }
  return sums;
}

const meshes::Snapshot& snapshot_at(const meshes::FieldHistory& history, double time) {
  const auto found = std::find_if(history.snapshots.begin(), history.snapshots.end(),
                                  [time](const auto& shot) { return shot.time == time; });
  if (found == history.snapshots.end()) throw std::logic_error("the yardstick has no output at that time");
  return *found;
}

}  // namespace

std::vector<double> water_below(const HardColumn& column, const meshes::Mesh& mesh, const meshes::Snapshot& shot,
                                const std::vector<double>& elevations) {
  return below(pieces(column, mesh, shot), elevations);
}

double misplaced_water(const HardColumn& column, const meshes::FieldHistory& mpm,
                       const meshes::FieldHistory& reference) {
  const double height = column.surface > 0 ? column.surface : column.height;
  constexpr int parts = 200;
  std::vector<double> z;
  for (int k = 0; k <= parts; ++k) z.push_back(height * k / parts);
  const meshes::Snapshot& last = mpm.snapshots.back();
  const auto at = [&](const meshes::FieldHistory& history, const meshes::Snapshot& shot) {
    return water_below(column, history.mesh, shot, z);
  };
  // What has changed since the start: cells and nodes hold slightly different water at the same pressures.
  const auto now = at(mpm, last), before = at(mpm, snapshot_at(mpm, 0));
  const auto true_now = at(reference, snapshot_at(reference, last.time)),
             true_before = at(reference, snapshot_at(reference, 0));
  double area = 0, moved = 0;
  for (std::size_t k = 0; k < z.size(); ++k) {
    area += std::abs(now[k] - before[k] - true_now[k] + true_before[k]) * height / parts;
    moved = std::max(moved, std::abs(true_now[k] - true_before[k]));
  }
  const double cell = column.height / static_cast<double>(mpm.mesh.cell_count());
  // Of less than a millimetre of water the place means little.
  return area / std::max(moved, 1e-3) / cell;
}

double pressure_difference(const meshes::FieldHistory& mpm, const meshes::FieldHistory& reference, double driest) {
  const meshes::Snapshot &last = mpm.snapshots.back(), &true_one = snapshot_at(reference, last.time);
  double worst = 0;
  for (std::size_t i = 0; i < mpm.mesh.node_count(); i += 2) {
    const double z = mpm.mesh.nodes[i][1];
    const auto above = std::lower_bound(reference.mesh.nodes.begin(), reference.mesh.nodes.end(), z - 1e-9,
                                        [](const meshes::Point& node, double at) { return node[0] < at; });
    if (above == reference.mesh.nodes.end()) continue;
    const double p = true_one.node_pressure[static_cast<std::size_t>(above - reference.mesh.nodes.begin())];
    const double difference = std::abs(last.node_pressure[i] - p);
    if (p > driest) worst = difference <= worst ? worst : difference;
  }
  return worst;
}

HardCase column_case(const ColumnRow& row) {
  HardCase out;
  out.name = row.name, out.title = row.title, out.requirement = row.requirement, out.source = row.source;
  out.effort = row.effort;
  out.problem = [column = row.column] { return strip_problem(column); };
  out.ends = row.ends.empty() ? std::vector<double>{row.column.outputs.back()} : row.ends;
  out.seepage_until = row.seepage_until;
  out.budget = row.budget;
  // Solved when first asked for: once for all schemes.
  struct Yardstick {
    meshes::FieldHistory reference;
    std::optional<meshes::FieldHistory> on_the_same_cells;
  };
  const auto kept = std::make_shared<std::optional<Yardstick>>();
  HardColumn watched = row.column;
  for (const double window : out.windows) watched.outputs.push_back(out.window_begin() + window);
  std::ranges::sort(watched.outputs);
  watched.outputs.erase(std::ranges::unique(watched.outputs).begin(), watched.outputs.end());
  out.judge = [row, watched, kept](const mpm::Problem<2>&, const meshes::FieldHistory& history) {
    if (!*kept) {
      kept->emplace(Yardstick{fem_reference::solve(line_problem(watched, row.finer)), {}});
      if (row.known_to_own_change) (*kept)->on_the_same_cells = fem_reference::solve(line_problem(watched, 1));
    }
    const Yardstick& yardstick = **kept;
    double bound = row.cells_off;
    if (yardstick.on_the_same_cells) {
      meshes::FieldHistory same = *yardstick.on_the_same_cells;
      std::erase_if(same.snapshots, [&](const auto& shot) { return shot.time > history.snapshots.back().time; });
      bound += misplaced_water(row.column, same, yardstick.reference);
    }
    return std::vector<Reading>{
        {"misplaced water", misplaced_water(row.column, history, yardstick.reference), {bound, "cells", row.reason}}};
  };
  return out;
}

}  // namespace wetfront::verification
