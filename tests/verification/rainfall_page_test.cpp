// What a study of rain on a slope says: where the order of wetting and the type of failure change, and the four
// figures of it.
#include "verification/study/rainfall_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace wetfront::verification {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr double conductivity = 3e-4;

PointResult slide(double depth, double order, double rate) {
  PointResult result;
  result.candidate = {{"failure_time", "", "s", std::isnan(depth) ? never : 1000},
                      {"failure_depth", "", "-", depth},
                      {"wetting_order", "", "s", order},
                      {"rise_rate:G-9", "", "m/s", rate},
                      {"arrival_time:G-9", "", "s", 500},
                      {"largest_displacement", "", "m", 0.25},
                      {"largest_velocity", "", "m/s", 0.5}};
  return result;
}

class Rain : public testing::Test {
 protected:
  void add(double ratio, const PointResult& result) { results.push_back(result), ratios.push_back(ratio); }
  reports::Record page() const {
    reports::Record record;
    tell_rain(record, outcomes());
    return record;
  }
  std::vector<RainOutcome> outcomes() const {
    std::vector<RainOutcome> rain;
    for (std::size_t i = 0; i < results.size(); ++i) rain.push_back({ratios[i], conductivity, &results[i]});
    return rain;
  }
  std::vector<PointResult> results;
  std::vector<double> ratios;
};

/// As a study has them: strongest first.
TEST_F(Rain, ChangesAreFoundBetweenNeighbours) {
  add(1, slide(0.1, 200, 3e-2));
  add(0.75, slide(0.2, 200, 3e-3));
  add(0.25, slide(0.9, 100, 6e-4));
  add(0.1, slide(0.9, -100, 3e-4));
  const reports::Record record = page();
  ASSERT_EQ(record.tables.size(), 1u);
  const std::string& said = record.tables[0].caption;
  EXPECT_THAT(said, HasSubstr("order of wetting changes between I/k_s = 0.1 and 0.25."));
  EXPECT_THAT(said, HasSubstr("type of failure changes between I/k_s = 0.25 and 0.75."));
  EXPECT_THAT(said, HasSubstr("critical ratio of 0.5 that Lee et al. (2021) read from their runs lies where"));
  EXPECT_EQ(record.tables[0].rows.front().front(), "0.1") << "weak rain first";
  ASSERT_EQ(record.figures.size(), 4u);
  EXPECT_THAT(record.figures[0].series[1].label, testing::IsEmpty()) << "a gauge stands in the legend once";
  EXPECT_THAT(record.figures[0].series[0].x, ElementsAre(0.1, 0.25, 0.75, 1));
  EXPECT_THAT(record.figures[0].series[0].y,
              ElementsAre(testing::DoubleNear(1, 1e-12), testing::DoubleNear(2, 1e-12), testing::DoubleNear(10, 1e-12),
                          testing::DoubleNear(100, 1e-12)))
      << "speed of rise over k_s";
  const auto& markers = record.figures[2].series;
  ASSERT_EQ(markers.size(), 3u);
  EXPECT_EQ(markers[1].label, "deep failure");
  EXPECT_THAT(markers[1].x, ElementsAre(0.1, 0.25));
  EXPECT_THAT(markers[2].x, ElementsAre(0.75, 1));
}

TEST_F(Rain, AnotherCriticalRatioIsSaidToBeAnother) {
  add(0.1, slide(0.9, -100, 3e-4));
  add(0.77, slide(0.9, 100, 3e-4));
  add(1.02, slide(0.1, 100, 3e-4));
  EXPECT_THAT(page().tables[0].caption, HasSubstr("is not where the type of failure changes here: that is above it."));
}

/// Deep, shallow, deep: no ratio parts them, and the page must not name one.
TEST_F(Rain, AChangeBackIsNoLimit) {
  add(0.1, slide(0.9, -100, 3e-4));
  add(0.5, slide(0.1, 100, 3e-4));
  add(1, slide(0.9, 100, 3e-4));
  EXPECT_FALSE(change_of_failure(outcomes()).once);
  EXPECT_THAT(page().tables[0].caption, HasSubstr("is no clear limit here"));
}

/// A slope that stands has no type, and does not part the others.
TEST_F(Rain, WhatDoesNotFailHasNoType) {
  add(0.05, slide(never, never, never));
  add(0.1, slide(0.9, -100, 3e-4));
  add(0.2, slide(0.8, -50, 3e-4));
  const reports::Record record = page();
  EXPECT_FALSE(change_of_failure(outcomes()).found);
  EXPECT_THAT(record.tables[0].caption, HasSubstr("type of failure is the same at all"));
  EXPECT_THAT(record.tables[0].rows[0], testing::Contains("never"));
  EXPECT_EQ(record.figures[2].series.back().label, "did not fail");
}

/// Rain on a column slides nothing.
TEST_F(Rain, NothingIsSaidWhereNoBodyWasFollowed) {
  PointResult column;
  column.candidate = {{"rise_rate:base", "", "m/s", 1e-4}};
  add(0.1, column);
  add(0.5, column);
  EXPECT_TRUE(page().tables.empty());
  EXPECT_TRUE(page().figures.empty());
}

}  // namespace
}  // namespace wetfront::verification
