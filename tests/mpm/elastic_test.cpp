// The elastic skeleton: gravity column, no allocation in a step, the bytes of a plan.
#include "mpm/plan/derive_effects.h"
#include "mpm/plan/stage_plan.h"
#include "mpm/simulation.h"
#include "tests/mpm/sheared_sand.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};

/// What is allocated at this moment, while `watching`: how much was asked for, and where.
struct Allocation {
  const void* place;
  std::size_t bytes;
};
std::array<Allocation, 1 << 16> living;
std::size_t living_count = 0;
bool watching = false;

void forget(const void* memory) {
  for (std::size_t k = living_count; watching && k-- > 0;)
    if (living[k].place == memory) {
      living[k] = living[--living_count];
      return;
    }
}
}  // namespace

// Counts every allocation of this test program.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  if (watching && living_count < living.size()) living[living_count++] = {memory, size};
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  forget(memory);
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  forget(memory);
  std::free(memory);
}

namespace wetfront::mpm {
namespace {

constexpr double height = 1.0, young = 10e6, poisson = 0.3;
const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
const double density = (1 - 0.46) * 2690;

Problem<2> gravity_column(int cells, double damping, double end) {
  Problem<2> problem = test::seed_column(cells, 0.087, 0, end);
  problem.mesh = test::strip(height, cells);
  problem.water.reset();
  problem.initial_pressure.clear();
  problem.water_boundary.clear();
  problem.soils[0].retention.reset();
  problem.soils[0].permeability.reset();
  problem.soils[0].elastic = Elastic{young, poisson, "test:elastic"};
  problem.fixities = {
      {"base", {true, true, false}, "o"}, {"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  problem.stages[0].liquid.reset();
  problem.stages[0].local_damping = damping;
  problem.output_times = {end};
  return problem;
}

TEST(ElasticSkeleton, AGravityColumnSettlesToItsClosedForm) {
  const int cells = 20;
  const Problem<2> problem = gravity_column(cells, 0.2, 0.5);  // about 20 periods
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const State state = simulation.state();
  const double settlement = -state.history.snapshots.at(0).node_displacement[2 * cells][1];
  // Small strain: rho g H^2/(2M), 1 % by the issue.
  EXPECT_NEAR(settlement / (density * 9.81 * height * height / (2 * modulus)), 1, 0.01);
  // A linear cell carries one vertical stress, that of its centre: rho g (H - h/2). Horizontal: nu/(1-nu) of it.
  const auto& stress = state.fields.at("point.stress");
  const std::size_t points = stress.size() / 4;
  const double expected = -density * 9.81 * (height - 0.5 * height / cells);
  double mean = 0;
  for (std::size_t p = 0; p < 4; ++p) mean += stress[points + p] / 4;
  EXPECT_NEAR(mean / expected, 1, 0.01);
  EXPECT_NEAR(stress[0] / stress[points], poisson / (1 - poisson), 0.01);
}

TEST(ElasticSkeleton, AnUndampedColumnSwingsAtItsPeriod) {
  // First mode of a column fixed at its base: T = 4 H / c. The lumped mass and 40 cells leave 0.1 %.
  const double period = 4 * height / std::sqrt(modulus / density);
  const Problem<2> problem = gravity_column(40, 0, 2 * period);
  Simulation<2> simulation(problem);
  double last = 0, crossing = 0;
  const double settled = -density * 9.81 * height * height / (2 * modulus);
  // The top starts at 0, above the rest position, and passes through it upwards at 3/4 of a period.
  while (!simulation.finished() && crossing == 0) {
    simulation.step();
    const auto state = simulation.state();
    const double u = state.fields.at("node.displacement")[2 * 41 + 2 * 40] - settled;
    if (last < 0 && u >= 0) crossing = state.time;
    last = u;
  }
  EXPECT_NEAR(crossing / period, 0.75, 0.015);
}

TEST(ElasticSkeleton, AStepAllocatesNothing) {
  Simulation<2> simulation(gravity_column(20, 0.1, 1.0));
  for (int warm_up = 0; warm_up < 10; ++warm_up) simulation.step();
  const long before = allocations;
  for (int step = 0; step < 500; ++step) simulation.step();
  EXPECT_EQ(allocations - before, 0);
}

TEST(ElasticSkeleton, PointsThatChangeCellsAllocateNothingOnceTheirRoomIsThere) {
  Problem<2> problem = test::sheared_sand(1024, 4, 1);
  problem.stages[0].end_time = 10;
  Simulation<2> simulation(problem);
  for (int warm_up = 0; warm_up < 1000; ++warm_up) simulation.step();
  const double crossed = simulation.take_history().counters.at("points that changed cells");
  const long before = allocations;
  for (int step = 0; step < 200; ++step) simulation.step();
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(simulation.take_history().counters.at("points that changed cells"), crossed + 100);
}

/// The same with water of two velocities: its body, walls, rained faces and surface are found anew as cells fill and
/// empty, a hundred times in these steps. Under rain, lists may still grow once or twice: more nodes are rained on than
/// ever before (it was 10 allocations a step).
TEST(ElasticSkeleton, AWetBodyThatMovesAllocatesNothingOnceItsRoomIsThere) {
  for (const bool rained : {false, true})
    for (const bool loaded : {false, true}) {
      Problem<2> problem = test::sheared_wet_sand(1024, 4, 1);
      if (rained) problem.water_boundary.push_back(RainSide{free_surface, {{0.0}, {1e-4}}, "test:rain"});
      if (loaded) problem.skeleton_boundary.push_back(Traction{free_surface, 1e3, {}, {}, "test:load"});
      Simulation<2> simulation(problem);
      for (int warm_up = 0; warm_up < 500; ++warm_up) simulation.step();
      const double crossed = simulation.take_history().counters.at("points that changed cells");
      const long before = allocations;
      for (int step = 0; step < 200; ++step) simulation.step();
      EXPECT_LE(allocations - before, rained ? 20 : 0) << (rained ? "rained " : "") << (loaded ? "loaded" : "");
      EXPECT_GT(simulation.take_history().counters.at("points that changed cells"), crossed + 50);
    }
}

/// What `explain` prints is what the allocator was asked for: slots that hold no point are in it, and lanes' tails.
TEST(ElasticSkeleton, TheBytesOfThePlanAreThoseAllocated) {
  for (const auto& problem : {gravity_column(20, 0.1, 1.0), test::sheared_sand(1024, 4, 1),
                              test::sheared_sand(900, 9, 1), test::sheared_wet_sand(1024, 4, 1)}) {
    const PlanInfo told = plan(problem).at(0);
    living_count = 0;
    watching = true;
    Fields<2> fields(problem);
    const auto made = make_plan(problem, 0, fields);
    made->enter();
    std::size_t bytes = 0;
    for (const auto& column : fields.points.columns.all()) {
      const auto* const end = living.data() + living_count;
      const auto* const block =
          std::find_if(static_cast<const Allocation*>(living.data()), end,
                       [&](const Allocation& one) { return one.place == column->values().data(); });
      if (block != end) bytes += block->bytes;
    }
    watching = false;
    ASSERT_LT(living_count, living.size());
    std::size_t listed = 0;
    for (const ColumnInfo& column : told.columns) listed += column.bytes_per_point;
    EXPECT_EQ(told.point_bytes, bytes) << told.scheme;
    EXPECT_EQ(listed * told.slots, bytes) << told.scheme;
    EXPECT_EQ(told.slots, fields.points.slots());
    EXPECT_GE(told.slots, told.points);
  }
}

TEST(ElasticSkeleton, StaysStableAtItsLimit) {
  Problem<2> problem = gravity_column(20, 0, 0.5);
  problem.stages[0].step_safety = 1.0;
  const auto history = run<2>(problem);
  // Twice the static settlement is the largest swing of a column let go.
  const double static_settlement = density * 9.81 * height * height / (2 * modulus);
  EXPECT_LT(std::abs(history.snapshots.at(0).node_displacement[40][1]), 2.1 * static_settlement);
}

TEST(ElasticSkeleton, PointsThatWouldLeaveTheMeshAreHeldAndCounted) {
  Problem<2> problem = gravity_column(10, 0, 0.3);
  problem.fixities.clear();  // falls onto the border of the mesh
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const State state = simulation.state();
  EXPECT_GT(state.history.counters.at("points held at the mesh border"), 0);
  const auto& position = state.fields.at("point.position");
  for (std::size_t p = position.size() / 2; p < position.size(); ++p) {
    EXPECT_GE(position[p], -1e-9);
    EXPECT_LE(position[p], height + 1e-9);
  }
}

}  // namespace
}  // namespace wetfront::mpm
