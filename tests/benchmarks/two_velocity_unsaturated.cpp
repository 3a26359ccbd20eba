// Whole steps of unsaturated Mohr-Coulomb soil with the two-velocity liquid (implicit drag), plane, linear
// quadrilaterals, points crossing cells.
#include "tests/benchmarks/moving_body.h"

namespace wetfront::mpm::bench {
namespace {

const auto* const registered = [] {
  const auto timed = [](benchmark::internal::Benchmark* b) { return b->Unit(benchmark::kMillisecond); };
  for (long points : {10000L, 100000L, 1000000L, 4000000L})
    timed(benchmark::RegisterBenchmark("step/two_velocity_unsaturated", [](benchmark::State& b) {
      step(b, test::sheared_wet_sand(b.range(0), 4, 1));
    }))->Arg(points);
  return timed(benchmark::RegisterBenchmark(
                   "step/two_velocity_unsaturated_two_threads",
                   [](benchmark::State& b) { step(b, test::sheared_wet_sand(b.range(0), 4, 2)); }))
      ->Arg(100000)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}();

}  // namespace
}  // namespace wetfront::mpm::bench
