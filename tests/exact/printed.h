#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace wetfront::verification::exact {

/// Expects `value` to round to a number printed in benchmarks.md with `decimals` digits after the point: half a unit of
/// the last one, plus a tenth of it for the printed number's own last-digit rounding.
inline void expect_printed(double value, double printed, int decimals, const std::string& what = "") {
  EXPECT_NEAR(value, printed, 0.6 * std::pow(10.0, -decimals)) << what;
}

/// Records a residual (into the XML report and README.md's table) and bounds it.
inline void expect_residual(double worst, double bound, const char* name) {
  ::testing::Test::RecordProperty(name, std::to_string(worst));
  std::printf("[ residual ] %s %.1e\n", name, worst);
  EXPECT_LT(worst, bound) << name;
}

}  // namespace wetfront::verification::exact
