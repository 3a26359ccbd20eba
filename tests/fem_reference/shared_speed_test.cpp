// Run by mpirun on two ranks: the slope with 41,407 unknowns on one rank, then on both. The rank that waits sleeps.
#include "fem_reference/parallel.h"
#include "fem_reference/ranks/shared_solve.h"
#include "verification/suites/flume_slope.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

namespace fem = wetfront::fem_reference;

template <class Solve>
double wall_seconds(const char* label, const Solve& solve, double& stored) {
  const auto start = std::chrono::steady_clock::now();
  const auto history = solve();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  stored = history.ledger.back().stored;
  std::printf("%s: %.2f s, %.0f steps, %.0f Newton iterations", label, wall.count(), history.counters.at("steps"),
              history.counters.at("Newton iterations"));
  for (const auto& cost : history.cost) std::printf(", %s %.2f", cost.kernel.c_str(), cost.cpu_seconds);
  std::printf(" CPU s\n");
  std::fflush(stdout);
  return wall.count();
}

}  // namespace

/// Arguments: seconds of rain (1200), repeats (2). Exit code 1 where two ranks are not 1.5 times faster than one.
int main(int argc, char** argv) {
  const fem::Parallel parallel;
  if (!parallel.leads()) return parallel.serve();
  fem::RichardsProblem problem = wetfront::verification::flume_slope(880, 46);
  problem.end_time = argc > 1 ? std::atof(argv[1]) : 1200;
  problem.output_times = {problem.end_time};
  double one = 1e300, all = 1e300, stored_one = 0, stored_all = 0;
  for (int repeat = 0; repeat < (argc > 2 ? std::atoi(argv[2]) : 2); ++repeat) {
    one = std::min(one, wall_seconds(
                            "1 rank", [&] { return fem::march_alone(problem, nullptr); }, stored_one));
    all = std::min(all, wall_seconds(
                            "all ranks", [&] { return fem::solve(problem, nullptr); }, stored_all));
  }
  // Both keep the water to 1e-8 and differ by the tolerance of the steps.
  const double difference = std::abs(stored_one - stored_all) / stored_one;
  std::printf("%d ranks are %.2f times faster; stored water differs by %.1e\n", parallel.ranks(), one / all,
              difference);
  return one / all >= 1.5 && difference <= 10 * problem.tolerance ? 0 : 1;
}
