#include "verification/compare/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using reports::Verdict;

TEST(Verdict, PassesOnlyIfTheReferencesErrorFitsToo) {
  EXPECT_EQ(verdict(0.8, 0.1, 1), Verdict::pass);
  EXPECT_EQ(verdict(1.0, 0.0, 1), Verdict::pass);
  EXPECT_EQ(verdict(0.95, 0.1, 1), Verdict::inconclusive);
  EXPECT_EQ(verdict(1.05, 0.1, 1), Verdict::inconclusive);
  EXPECT_EQ(verdict(1.2, 0.1, 1), Verdict::fail);
}

TEST(Verdict, AReferenceAsUncertainAsTheToleranceCannotCondemn) {
  EXPECT_EQ(verdict(14, 11, 2), Verdict::inconclusive);
  EXPECT_EQ(verdict(14, 1, 2), Verdict::fail);
}

TEST(Verdict, WhatIsNotANumberDoesNotPass) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(verdict(nan, 0, 1), Verdict::inconclusive);
  EXPECT_EQ(verdict(0, nan, 1), Verdict::inconclusive);
  EXPECT_EQ(verdict(infinity, 0, 1), Verdict::fail);
  EXPECT_EQ(verdict(0, infinity, 1), Verdict::inconclusive);
}

/// A scene with two comparison times and the given tolerances; no solver is involved.
struct Judged {
  Scene scene;
  Timeline timeline;
  Judged() { timeline.comparison_times = {10, 20}; }
  void gate(const std::string& quantity, double value, std::optional<double> at = {}) {
    Tolerance tolerance{quantity, {}, "", value, "because", {}};
    if (at) tolerance.at = SceneTime{*at, false, {}};
    scene.comparison.tolerances.push_back(tolerance);
    timeline.tolerance_times.push_back(at ? *at : std::nan(""));
  }
  std::vector<reports::Finding> operator()(const std::vector<Measurement>& measurements) const {
    return judge(scene, timeline, measurements, 1.5);
  }
};

TEST(Judge, TheToleranceThatNamesTheTimeCounts) {
  Judged judged;
  judged.gate("pressure_l2", 0.1);
  judged.gate("pressure_l2", 0.01, 20);
  const auto findings = judged({{"pressure_l2", "", 0, "", 0.05, {}, ""}, {"pressure_l2", "", 1, "", 0.05, {}, ""}});
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].verdict, Verdict::pass);
  EXPECT_EQ(findings[1].verdict, Verdict::fail);
  EXPECT_EQ(findings[1].tolerance, 0.01);
  EXPECT_EQ(findings[1].cpu_s, 1.5);
  EXPECT_EQ(overall(findings), Verdict::fail);
}

TEST(Judge, AToleranceThatNothingAnswersIsInconclusive) {
  Judged judged;
  judged.gate("ponding_time", 0.1);
  const auto findings = judged({{"ponding_time", "", -1, "", std::nan(""), {}, ""}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].verdict, Verdict::inconclusive);
  EXPECT_EQ(overall(findings), Verdict::inconclusive);
}

TEST(Judge, AGeneralToleranceIsAnsweredWhereTheQuantityExists) {
  Judged judged;
  judged.gate("front_position", 0.1);
  const auto findings =
      judged({{"front_position", "", 0, "", 0.05, {}, ""}, {"front_position", "", 1, "", std::nan(""), {}, ""}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].verdict, Verdict::pass);
}

TEST(Judge, WhatHasNoToleranceIsShownAndDoesNotDecide) {
  const auto findings = Judged()({{"pressure_linf", "", 0, "", 0.5, {}, ""}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].verdict, Verdict::info);
  EXPECT_EQ(overall(findings), Verdict::info);
}

}  // namespace
}  // namespace wetfront::verification
