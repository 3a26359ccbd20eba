#include "verification/exact/tracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"

namespace wetfront::verification::exact {
namespace {

constexpr double side = 15.24;
const double never = std::numeric_limits<double>::infinity();

// m and d
Tracy box(double alpha, Tracy::Sides sides, double depth_y = 0) {
  return {alpha, 1, 0.15, 0.45, -side, side, depth_y, side, sides};
}

/// theta_t = div(K grad h) + K_z, relative to the largest of the terms.
double residual(const Tracy& p, const TracySolution& s, double x, double y, double z, double t) {
  const double step = 0.4, k = p.conductivity * std::exp(p.alpha * s.head(x, y, z, t));
  const auto along = [&](int axis) {
    return [&s, axis, x, y, z, t](double shift) {
      return s.head(x + (axis == 0) * shift, y + (axis == 1) * shift, z + (axis == 2) * shift, t);
    };
  };
  double sum = 0, scale = 0;
  const auto add = [&](double term) { sum += term, scale = std::max(scale, std::abs(term)); };
  for (int axis : {0, 1, 2}) {
    if (axis == 1 && p.depth_y == 0) continue;
    const double slope = derivative(along(axis), 0, step);
    add(k * derivative(along(axis), 0, step, 2));
    add(p.alpha * k * slope * (slope + (axis == 2)));
  }
  const auto content = [&](double at) { return (p.theta_s - p.theta_r) * std::exp(p.alpha * s.head(x, y, z, at)); };
  return relative_residual(derivative(content, t, 0.2 * t), sum, scale);
}

TEST(Tracy, PrintedNumbers) {
  const TracySolution specified(box(0.328, Tracy::Sides::specified)), closed(box(0.328, Tracy::Sides::closed));
  const double times[] = {.1, .5, 1, 2, 5, never};
  const double rows[][7] = {{3.81, -15.24, -14.5927008, -9.2612380, -5.2258136, -3.8911771, -3.8504702},
                            {7.62, -15.2398674, -9.0799810, -4.8819923, -2.9662889, -2.3589922, -2.3402418},
                            {13.716, -3.1437438, -.9479466, -.6326674, -.4995049, -.4609426, -.4597922}};
  for (const auto& row : rows)
    for (int i = 0; i < 6; ++i) expect_printed(specified.head(7.62, row[0], times[i]), row[i + 1], 7, "specified");
  const double none[] = {-15.2398722, -9.3720604, -5.2341497, -3.1296566, -2.0849164, -1.9671269};
  for (int i = 0; i < 6; ++i) expect_printed(closed.head(7.62, 7.62, times[i]), none[i], 7, "no flux");
}

TEST(Tracy, SatisfiesRichardsInTwoAndThreeDimensions) {
  for (Tracy::Sides sides : {Tracy::Sides::specified, Tracy::Sides::closed})
    for (double depth_y : {0.0, 11.0}) {
      double worst = 0;
      for (double alpha : {.164, .328, .492}) {
        const Tracy p = box(alpha, sides, depth_y);
        const TracySolution s(p);
        for (double t : {.5, 1.0, 3.0})
          for (double z : {4.0, 8.0, 12.0}) {
            if (s.head(5, 4, z, t) - p.dry_head < 0.5) continue;  // nothing has arrived: nothing to balance
            worst = std::max(worst, residual(p, s, 5, 4, z, t));
          }
      }
      expect_residual(worst, 1e-6, depth_y > 0 ? "tracy_3d" : "tracy_2d");  // second differences, 11 digits in the dry
    }
}

TEST(Tracy, HoldsItsBoundaries) {
  const double dry = std::exp(-0.328 * side);
  const TracySolution sh(box(.328, Tracy::Sides::specified)), nf(box(.328, Tracy::Sides::closed));
  const TracySolution sh3(box(.328, Tracy::Sides::specified, 11)), nf3(box(.328, Tracy::Sides::closed, 11));
  const double pi = std::numbers::pi, wave = 4 * pi / side, wave_y = 4 * pi / 11;
  const double sx = std::sin(wave / 4 * 4), cx = (1 - std::cos(wave / 2 * 4)) / 2, sy = std::sin(wave_y / 4 * 3);
  const double cy = (1 - std::cos(wave_y / 2 * 3)) / 2;
  const auto top = [&](double lateral) { return std::log(dry + (1 - dry) * lateral) / .328; };
  EXPECT_NEAR(sh.head(4, side, 1), top(sx), 1e-10);
  EXPECT_NEAR(nf.head(4, side, 1), top(cx), 1e-10);
  EXPECT_NEAR(sh3.head(4, 3, side, 1), top(sx * sy), 1e-10);
  EXPECT_NEAR(nf3.head(4, 3, side, 1), top(cx * cy), 1e-10);
  for (const TracySolution* s : {&sh3, &nf3}) EXPECT_NEAR(s->head(4, 3, 0, 2), -side, 1e-9);
  EXPECT_NEAR(sh3.head(0, 3, 8, 2), -side, 1e-9);
  EXPECT_NEAR(sh3.head(4, 11, 8, 2), -side, 1e-9);
  // closed sides: even about the wall; the slope next to it falls with the distance
  EXPECT_NEAR((nf3.head(1e-3, 3, 8, 2) - nf3.head(0, 3, 8, 2)) / 1e-3, 0, 1e-3);
  EXPECT_NEAR((nf3.head(4, 1e-3, 8, 2) - nf3.head(4, 0, 8, 2)) / 1e-3, 0, 1e-3);
}

TEST(Tracy, StartsDryAndEndsSteady) {
  const TracySolution s(box(.328, Tracy::Sides::closed, 11));
  EXPECT_DOUBLE_EQ(s.head(4, 3, 8, 0), -side);
  EXPECT_NEAR(s.head(4, 3, 8, 1e-3), -side, 1e-6);
  EXPECT_NEAR(s.head(4, 3, 8, 200), s.steady_head(4, 3, 8), 1e-10);
}

TEST(Tracy, RefusesWhatItCannotGive) {
  const TracySolution few(box(.328, Tracy::Sides::specified), 10);
  EXPECT_THROW(few.head(4, 8, 1e-3), std::domain_error);
  EXPECT_THROW(few.head(4, 16, 1), std::domain_error);
  EXPECT_THROW(few.head(4, 8, -1), std::domain_error);
  Tracy p = box(.328, Tracy::Sides::specified);
  p.dry_head = 0;
  EXPECT_THROW(TracySolution{p}, std::invalid_argument);
  p = box(5, Tracy::Sides::specified);  // e^{-76}: 1e-33 cannot be told from rounding
  EXPECT_THROW(TracySolution(p).head(7, 5, 0.1), std::domain_error);
}

}  // namespace
}  // namespace wetfront::verification::exact
