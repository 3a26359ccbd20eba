// Whole steps of unsaturated Mohr-Coulomb soil with the two-velocity liquid (implicit drag), plane, linear
// quadrilaterals, points crossing cells.
#include "tests/benchmarks/moving_body.h"

namespace wetfront::mpm::bench {
namespace {

/// The moving body of the dry benchmark with water in its pores, at 4 kPa of suction; no water passes its surface.
Problem<2> wet_sand(long points, int per_cell) {
  Problem<2> problem = sheared_sand(points, per_cell, 1);
  problem.water = Water{1000, 2e8, 1e-3, "bench"};
  problem.soils[0].retention = VanGenuchtenRetention{4350, 0.61, 0.087, 1};
  problem.soils[0].permeability = MualemPermeability{};
  problem.initial_pressure.assign(problem.mesh.node_count(), -4e3);
  problem.stages[0].liquid = LiquidScheme::implicit_drag;
  return problem;
}

const auto* const registered = [] {
  benchmark::internal::Benchmark* last = nullptr;
  for (long points : {10000L, 100000L, 1000000L, 4000000L})
    last = benchmark::RegisterBenchmark("step/two_velocity_unsaturated",
                                        [](benchmark::State& b) { step(b, wet_sand(b.range(0), 4)); })
               ->Unit(benchmark::kMillisecond)
               ->MeasureProcessCPUTime()
               ->Arg(points);
  return last;
}();

}  // namespace
}  // namespace wetfront::mpm::bench
