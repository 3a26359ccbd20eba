// Whole steps of a dry Mohr-Coulomb body, plane, linear quadrilaterals, points crossing cells.
#include "mpm/plan.h"
#include "tests/benchmarks/moving_body.h"

namespace wetfront::mpm::bench {
namespace {

// Everything that a step does: kernels, migration, step limits, guard, record. Mixed points, 4 to a cell on average.
void step(benchmark::State& bench, int per_cell, int threads) {
  const Problem<2> problem = sheared_sand(bench.range(0), per_cell, threads);
  const PlanInfo info = plan(problem).at(0);
  run_steps(bench, problem, true, 20);
  bench.counters["bytes_per_point"] = static_cast<double>(info.point_bytes) / static_cast<double>(info.points);
}

// The bare kernels: the same where every cell holds four points in full lanes, none crosses, all is in the cache.
// What `step` reaches of its items per second is the share of the bare limit.
void bare(benchmark::State& bench) {
  Problem<2> problem = sheared_sand(bench.range(0), 4, 1);
  problem.initial_velocity = nullptr;
  run_steps(bench, problem, false, 5);
}

const auto* const registered = [] {
  const auto sizes = [](benchmark::internal::Benchmark* b) {
    return b->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
  };
  for (long points : {10000L, 100000L, 1000000L, 4000000L}) {
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb", [](benchmark::State& b) {
      step(b, 4, 1);
    }))->Arg(points);
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb_9_per_cell", [](benchmark::State& b) {
      step(b, 9, 1);
    }))->Arg(points);
  }
  for (long points : {100000L, 1000000L})
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb_two_threads", [](benchmark::State& b) { step(b, 4, 2); }))
        ->Arg(points)
        ->UseRealTime();
  return sizes(benchmark::RegisterBenchmark("bare/dry_mohr_coulomb", bare))->Arg(10000);
}();

}  // namespace
}  // namespace wetfront::mpm::bench
