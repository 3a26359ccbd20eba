// The source of a manufactured solution against differences of the operator itself, from head, content and conductivity
// alone: no derivative written by hand is used twice.
#include "verification/exact/manufactured.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/exact/derivative.h"

namespace wetfront::verification::exact {
namespace {

Manufactured waves(int dim) {
  Manufactured p;
  p.soil = VanGenuchten{0.08, 0.43, 4.0, 1.8, 1e-5};
  p.gravity[dim - 1] = -1;
  p.mean = -0.9;
  p.waves = {{0.3, {2.0, 1.3, 0.7}, 2e-4, 0.4}, {0.2, {-1.1, 2.4, 1.9}, -3e-4, 1.1}};
  for (auto& wave : p.waves)
    for (int axis = dim; axis < 3; ++axis) wave.wave_vector[axis] = 0;
  return p;
}

/// theta_t - div(K T (grad psi - g)), every derivative by extrapolated differences.
double operator_by_differences(const Manufactured& p, const std::array<double, 3>& at, double t) {
  const ManufacturedSolution solution(p);
  const auto shifted = [](std::array<double, 3> x, int axis, double by) {
    x[axis] += by;
    return x;
  };
  const auto flux = [&](const std::array<double, 3>& x, int axis) {  // component of K T (grad psi - g)
    const int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    double sum = 0;
    for (int j = 0; j < 3; ++j)
      sum += p.anisotropy[entry[axis][j]] *
             (derivative([&](double d) { return solution.head(shifted(x, j, d), t); }, 0, 0.2) - p.gravity[j]);
    return solution.conductivity(solution.head(x, t)) * sum;
  };
  double result = derivative([&](double s) { return solution.content(solution.head(at, s)); }, t, 2000);
  for (int axis = 0; axis < 3; ++axis)
    result -= derivative([&](double d) { return flux(shifted(at, axis, d), axis); }, 0, 0.2);
  return result;
}

// Sources are about 1e-5 1/s; the extrapolated differences of first derivatives leave about 1e-9 of that.
void expect_source(const Manufactured& p) {
  const ManufacturedSolution solution(p);
  for (const double t : {0.0, 700.0, 5000.0})
    for (const std::array<double, 3>& at : {std::array{0.1, 0.2, 0.3}, {0.9, 0.5, 0.7}, {0.4, 0.95, 0.05}})
      EXPECT_NEAR(solution.source(at, t), operator_by_differences(p, at, t), 1e-12) << t;
}

TEST(Manufactured, SourceIsTheOperatorAppliedToTheHead) {
  for (const int dim : {1, 2, 3}) {
    Manufactured p = waves(dim);
    expect_source(p);
    p.soil = ManufacturedGardner{0.06, 0.40, 3.0, 1e-5};
    expect_source(p);
    p.anisotropy = {3, 0.5, 2, 0.4, -0.3, 0.2};
    expect_source(p);
    p.gravity = {0.6, 0, -0.8};
    expect_source(p);
  }
}

TEST(Manufactured, RefusesWhatIsNotUnsaturated) {
  Manufactured p = waves(2);
  p.mean = -0.5;
  EXPECT_THROW(ManufacturedSolution{p}, std::invalid_argument);
}

}  // namespace
}  // namespace wetfront::verification::exact
