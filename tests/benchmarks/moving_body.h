#pragma once

#include "mpm/plan.h"
#include "mpm/simulation.h"
#include "tests/mpm/sheared_sand.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numeric>

/// What a step of a body costs whose points move from cell to cell.
namespace wetfront::mpm::bench {

using test::sheared_sand;

/// The state of a body some time after its start: every point moved by a random part of half a cell, so that cells hold
/// unequal numbers of points in no order, as they do once the body has been sheared.
inline State mixed(const Problem<2>& problem, const State& start) {
  State state = start;
  const auto& x = start.fields.at("point.position");
  const std::size_t points = x.size() / 2, cells = problem.mesh.cell_count();
  const double h = problem.mesh.nodes[1][0], width = problem.mesh.nodes.back()[0],
               height = problem.mesh.nodes.back()[1];
  const auto across = static_cast<std::size_t>(std::lround(width / h));
  std::uint64_t seed = 88172645463325252ull;  // xorshift, the same on every machine
  const auto random = [&seed] {
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return static_cast<double>(seed >> 11) * 0x1p-53 - 0.5;
  };
  std::vector<double> place[2];
  std::vector<std::size_t> cell_of;
  for (std::size_t p = 0; p < points; ++p) {
    const double px = std::clamp(x[p] + h * random(), 0.0, width),
                 py = std::clamp(x[points + p] + h * random(), 0.0, height);
    place[0].push_back(px), place[1].push_back(py);
    cell_of.push_back(std::min(static_cast<std::size_t>(py / h), cells / across - 1) * across +
                      std::min(static_cast<std::size_t>(px / h), across - 1));
  }
  std::vector<std::size_t> order(points);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cell_of[a] < cell_of[b]; });
  auto& counts = state.fields.at("points per cell");
  std::fill(counts.begin(), counts.end(), 0.0);
  for (std::size_t cell : cell_of) counts[cell] += 1;
  for (auto& [name, values] : state.fields) {
    if (!name.starts_with("point.")) continue;
    const bool position = name == "point.position";
    for (std::size_t c = 0; c < values.size() / points; ++c) {
      const std::vector<double> old(values.begin() + static_cast<std::ptrdiff_t>(c * points),
                                    values.begin() + static_cast<std::ptrdiff_t>((c + 1) * points));
      for (std::size_t p = 0; p < points; ++p) values[c * points + p] = position ? place[c][order[p]] : old[order[p]];
    }
  }
  return state;
}

/// Runs steps; items are point-steps per CPU second of the one thread (of two threads: by wall clock). Counters: cells
/// changed per step and point, kernels' own CPU time.
inline void run_steps(benchmark::State& bench, const Problem<2>& problem, bool mix, int warm_up) {
  const State start = Simulation<2>(problem).state();
  Simulation<2> simulation = mix ? Simulation<2>(problem, mixed(problem, start)) : Simulation<2>(problem);
  const std::size_t points = start.fields.at("point.volume").size();
  for (int step = 0; step < warm_up; ++step) simulation.step();
  const auto counter = [](const meshes::FieldHistory& history, const char* name) { return history.counters.at(name); };
  const auto before = simulation.take_history();
  for (auto _ : bench) simulation.step();
  const auto after = simulation.take_history();
  const double steps = counter(after, "steps") - counter(before, "steps"), count = static_cast<double>(points);
  bench.SetItemsProcessed(static_cast<std::int64_t>(steps * count));
  bench.counters["crossings_per_step"] =
      (counter(after, "points that changed cells") - counter(before, "points that changed cells")) / steps;
  bench.counters["points"] = count;
  for (const auto& kernel : after.cost) {
    double earlier = 0;
    for (const auto& other : before.cost)
      if (other.kernel == kernel.kernel && other.phase == kernel.phase) earlier = other.cpu_seconds;
    bench.counters["ns_" + kernel.kernel] = 1e9 * (kernel.cpu_seconds - earlier) / (steps * count);
  }
}

/// Everything that a step does: kernels, migration, step limits, guard, record. Mixed points.
inline void step(benchmark::State& bench, const Problem<2>& problem) {
  const PlanInfo info = plan(problem).at(0);
  run_steps(bench, problem, true, 20);
  bench.counters["bytes_per_point"] = static_cast<double>(info.point_bytes) / static_cast<double>(info.points);
}

}  // namespace wetfront::mpm::bench
