// Whole steps of a dry Mohr-Coulomb body, plane, linear quadrilaterals, points crossing cells.
#include "tests/benchmarks/moving_body.h"

namespace wetfront::mpm::bench {
namespace {

// The bare kernels: the same where every cell holds four points in full lanes, none crosses, all is in the cache.
// What step() reaches of its items per second is the share of the bare limit.
void bare(benchmark::State& bench) {
  Problem<2> problem = sheared_sand(bench.range(0), 4, 1);
  problem.initial_velocity = nullptr;
  run_steps(bench, problem, false, 5);
}

const auto* const registered = [] {
  // One thread does all the work, so its CPU time is that of the process, and the names stay plain.
  const auto sizes = [](benchmark::internal::Benchmark* b) { return b->Unit(benchmark::kMillisecond); };
  for (long points : {10000L, 100000L, 1000000L, 4000000L}) {
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb", [](benchmark::State& b) {
      step(b, sheared_sand(b.range(0), 4, 1));
    }))->Arg(points);
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb_9_per_cell", [](benchmark::State& b) {
      step(b, sheared_sand(b.range(0), 9, 1));
    }))->Arg(points);
  }
  for (long points : {100000L, 1000000L})
    sizes(benchmark::RegisterBenchmark("step/dry_mohr_coulomb_two_threads",
                                       [](benchmark::State& b) { step(b, sheared_sand(b.range(0), 4, 2)); }))
        ->Arg(points)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  return sizes(benchmark::RegisterBenchmark("bare/dry_mohr_coulomb", bare))->Arg(10000);
}();

}  // namespace
}  // namespace wetfront::mpm::bench
