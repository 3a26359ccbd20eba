#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace wetfront::verification::exact {

/// Expects `value` to round to a number printed in benchmarks.md with `decimals` digits after the point: half a unit of
/// the last one, plus a tenth of it for the printed number's own last-digit rounding.
inline void expect_printed(double value, double printed, int decimals, const std::string& what = "") {
  EXPECT_NEAR(value, printed, 0.6 * std::pow(10.0, -decimals)) << what;
}

/// Records a residual (into the XML report; the README's table is read from there) and bounds it.
inline void expect_residual(double worst, double bound, const char* name) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", worst);
  ::testing::Test::RecordProperty(name, text);
  std::printf("[ residual ] %s %s\n", name, text);
  EXPECT_LT(worst, bound) << name;
}

}  // namespace wetfront::verification::exact
