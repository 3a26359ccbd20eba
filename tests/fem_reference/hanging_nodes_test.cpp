#include "fem_reference/space/transfer.h"

#include "meshes/mesh.h"
#include "tests/fem_reference/adapted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

double linear(const meshes::Point& p) {
  return -3 + 0.7 * p[0] - 0.4 * p[1] + 0.9 * p[2];
}

RichardsProblem distorted(int dim) {
  RichardsProblem problem;
  problem.mesh = dim == 2 ? strip_mesh(4, 1, 4) : block_mesh(2);
  distort(problem.mesh);
  problem.gravity_direction[dim - 1] = -1;
  problem.soils = {seed_sand(0.087)};
  for (const meshes::Point& p : problem.mesh.nodes) problem.initial_head.push_back(linear(p));
  problem.boundary = {FluxSide{"top", {{0}, {1e-5}}}};
  problem.end_time = 1;
  problem.adaptivity = Adaptivity{3, 1e-3};
  return problem;
}

/// Nested enough to have every kind of constraint: three rounds of random halving and joining.
void adapt_at_random(Space& space, unsigned seed, int rounds = 3) {
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round) space.adapt(random_marks(space.discretisation(), random));
}

/// Corners of cells, each once, in physical space.
double corner(const Discretisation& space, int cell, int v, const std::vector<double>& field) {
  double value = 0;
  for (int a = 0; a < space.dofs_per_cell; ++a) {
    value += space.corner_shape_of(cell)[v * space.dofs_per_cell + a] * field[space.dofs_of(cell)[a]];
  }
  return value;
}

class HangingNodes : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, HangingNodes, ::testing::Values(2, 3));

TEST_P(HangingNodes, AreThere) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  adapt_at_random(space, 5);
  const Discretisation d = space.discretisation();
  EXPECT_GT(std::set<int>(d.cell_pattern.begin(), d.cell_pattern.end()).size(), GetParam() == 2 ? 6U : 20U);
  std::set<int> levels;
  for (const Box& box : d.box) levels.insert(box.level);
  EXPECT_GE(levels.size(), 3U);
}

// At Gauss points, cell centres and corners a linear field has its value and its gradient, whatever hangs. Rounding.
TEST_P(HangingNodes, ReproduceLinearHeads) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  adapt_at_random(space, 5);
  const Discretisation d = space.discretisation();
  std::vector<double> head(d.dof_count), x(d.dof_count), y(d.dof_count), z(d.dof_count);
  for (int i = 0; i < d.dof_count; ++i) {
    head[i] = linear(d.position[i]);
    x[i] = d.position[i][0];
    y[i] = d.position[i][1];
    z[i] = d.position[i][2];
  }
  const double expected[3] = {0.7, -0.4, 0.9};
  for (int cell = 0; cell < d.cell_count; ++cell) {
    for (int v = 0; v < d.corners(); ++v) {
      const meshes::Point place{corner(d, cell, v, x), corner(d, cell, v, y), corner(d, cell, v, z)};
      EXPECT_NEAR(corner(d, cell, v, head), linear(place), 1e-13);
    }
    for (int q = 0; q < d.points_per_cell; ++q) {
      for (int axis = 0; axis < d.dim; ++axis) {
        double slope = 0;
        for (int a = 0; a < d.dofs_per_cell; ++a) {
          const std::size_t point = static_cast<std::size_t>(cell) * d.points_per_cell + q;
          slope += d.gradient[(point * d.dofs_per_cell + a) * d.dim + axis] * head[d.dofs_of(cell)[a]];
        }
        EXPECT_NEAR(slope, expected[axis], 1e-11);
      }
    }
  }
}

// Patch test: a linear head in a soil of one K is steady, so what flows into a node inside the soil is zero. It is not
// where shape functions have a jump across a face. Against the largest single term, K |grad N| V ~ 1e-5.
TEST_P(HangingNodes, LeaveASteadyLinearHeadAlone) {
  RichardsProblem problem = distorted(GetParam());
  problem.soils[0].conductivity = ConstantConductivity{};
  problem.soils[0].anisotropy = principal_tensor(GetParam(), {4, 0.7, 1}, 0.5);
  Space space(problem);
  adapt_at_random(space, 5);
  Operator op(problem, space.discretisation());
  std::vector<double> head;
  for (const meshes::Point& p : op.space.position) head.push_back(linear(p));
  op.flow.evaluate(head);
  const Discretisation& d = op.space;
  int inside = 0;
  const auto on_hull = [&](const Box& box, int v) {
    const int n = GetParam() == 2 ? 4 : 2, full = 1 << d.levels;
    for (int axis = 0; axis < d.dim; ++axis) {
      const int cells[3] = {box.mesh_cell % n, box.mesh_cell / n % n, box.mesh_cell / (n * n)};
      const int place = cells[axis] * full + box.low[axis] + ((v >> axis & 1) << (d.levels - box.level));
      if (place == 0 || place == n * full) return true;
    }
    return false;
  };
  std::vector<char> hull(d.dof_count, 0);
  for (int cell = 0; cell < d.cell_count; ++cell) {
    for (int v = 0; v < d.corners(); ++v) {
      if (on_hull(d.box[cell], v)) hull[d.dofs_of(cell)[v]] = 1;
    }
  }
  for (int i = 0; i < d.dof_count; ++i) {
    if (hull[i]) continue;
    ++inside;
    EXPECT_NEAR(op.flow.inflow()[i], 0, 1e-17);
  }
  EXPECT_GT(inside, 20);
}

// Lumped masses and sides keep the soil and its surface: the hanging nodes' shares went to their masters.
TEST_P(HangingNodes, KeepVolumeAndArea) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  const Discretisation before = space.discretisation();
  adapt_at_random(space, 11);
  const Discretisation after = space.discretisation();
  ASSERT_NE(before.dof_count, after.dof_count);
  const auto volume = [](const Discretisation& d) {
    return std::accumulate(d.storage.begin(), d.storage.end(), 0.0,
                           [](double sum, const StorageShare& s) { return sum + s.volume; });
  };
  const auto area = [](const Discretisation& d) {
    return std::accumulate(d.sides[0].begin(), d.sides[0].end(), 0.0,
                           [](double sum, const SideShare& s) { return sum + s.horizontal_area; });
  };
  EXPECT_NEAR(volume(after), volume(before), 1e-13);
  EXPECT_NEAR(area(after), area(before), 1e-13);
  for (const StorageShare& share : after.storage) EXPECT_GT(share.volume, 0);
}

// The Jacobian by hand against central differences, as StageKernel.JacobianIsTheDerivative.
TEST_P(HangingNodes, HaveTheRightJacobian) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  adapt_at_random(space, 5, 2);
  Operator op(problem, space.discretisation());
  std::vector<double> head;
  for (const meshes::Point& p : op.space.position) head.push_back(0.3 * linear(p) + 0.1 * p[0] * p[1]);
  const double tau = 500, step = 1e-6;
  SparseMatrix matrix = op.flow.pattern();
  op.flow.evaluate(head);
  op.flow.assemble(tau, matrix);
  const int n = op.space.dof_count;
  double largest = 0, worst = 0;
  for (int j = 0; j < n; j += 7) {
    std::vector<double> rows[2];
    for (int side = 0; side < 2; ++side) {
      std::vector<double> moved = head;
      moved[j] += side == 0 ? step : -step;
      op.flow.evaluate(moved);
      for (int i = 0; i < n; ++i) {
        rows[side].push_back(op.flow.volume()[i] * op.flow.water()[i] - tau * op.flow.inflow()[i]);
      }
    }
    for (int i = 0; i < n; ++i) {
      double entry = 0;
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        if (matrix.column[k] == j) entry = matrix.value[k];
      }
      largest = std::max(largest, std::abs(entry));
      worst = std::max(worst, std::abs(entry - (rows[0][i] - rows[1][i]) / (2 * step)));
    }
  }
  EXPECT_LT(worst, 1e-5 * largest);  // step^2 W''' and rounding / step
}

// Heads of a wet blob in dry soil, steep enough that interpolation gains and loses water.
double blob(const meshes::Point& p) {
  return -2 + 1.9 * std::exp(-8 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
}

TEST_P(HangingNodes, TransferKeepsTheWater) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  adapt_at_random(space, 3, 1);
  auto now = std::make_unique<Operator>(problem, space.discretisation());
  std::vector<double> head;
  for (const meshes::Point& p : now->space.position) head.push_back(blob(p));
  std::mt19937 random(2);
  for (int round = 0; round < 6; ++round) {
    ASSERT_TRUE(space.adapt(random_marks(now->space, random)));
    auto next = std::make_unique<Operator>(problem, space.discretisation());
    const std::vector<char> fixed(next->space.dof_count, 0);
    const Transferred moved = transfer(now->flow, head, next->flow, fixed);
    const double before = now->flow.stored(now->flow.water_at(head));
    const double after = next->flow.stored(next->flow.water_at(moved.head));
    EXPECT_GT(moved.moved, 1e-6 * before);  // there was something to put right
    EXPECT_NEAR(after, before, 1e-12 * before);
    EXPECT_NEAR(moved.lost, before - after, 1e-15);
    for (const double h : moved.head) EXPECT_LE(h, 0);
    head = moved.head;
    now = std::move(next);
  }
}

// Halving then joining again gives the heads back where the water was right from the start.
TEST_P(HangingNodes, TransferIsExactWhereNothingChanges) {
  const RichardsProblem problem = distorted(GetParam());
  Space space(problem);
  adapt_at_random(space, 3, 1);
  Operator now(problem, space.discretisation());
  std::vector<double> head;
  for (const meshes::Point& p : now.space.position) head.push_back(blob(p));
  std::vector<Space::Mark> marks(now.space.cell_count, Space::Mark::keep);
  marks[0] = Space::Mark::halve;
  ASSERT_TRUE(space.adapt(marks));
  Operator next(problem, space.discretisation());
  const Transferred moved = transfer(now.flow, head, next.flow, std::vector<char>(next.space.dof_count, 0));
  int same = 0;
  for (int i = 0; i < next.space.dof_count; ++i) {
    const auto there = std::find(now.space.position.begin(), now.space.position.end(), next.space.position[i]);
    if (there == now.space.position.end()) continue;
    same += moved.head[i] == head[there - now.space.position.begin()] ? 1 : 0;
  }
  EXPECT_GT(same, now.space.dof_count / 2);
  EXPECT_LT(same, next.space.dof_count);
}

// Saturated soil without storage has no room: what interpolation would gain or lose there is told, not hidden.
TEST(Transfer, TellsWhatItCannotPlace) {
  RichardsProblem problem = distorted(2);
  problem.soils[0].specific_storage = 0;
  Space space(problem);
  Operator now(problem, space.discretisation());
  std::vector<double> head;
  for (const meshes::Point& p : now.space.position) head.push_back(blob(p));
  ASSERT_TRUE(space.adapt(std::vector<Space::Mark>(now.space.cell_count, Space::Mark::halve)));
  Operator next(problem, space.discretisation());
  const std::vector<char> all(next.space.dof_count, 1);  // as if every head were given
  const Transferred moved = transfer(now.flow, head, next.flow, all);
  const double before = now.flow.stored(now.flow.water_at(head));
  const double after = next.flow.stored(next.flow.water_at(moved.head));
  EXPECT_GT(std::abs(before - after), 1e-6);
  EXPECT_EQ(moved.lost, before - after);
}

}  // namespace
}  // namespace wetfront::fem_reference
