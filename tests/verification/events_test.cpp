#include "verification/compare/events.h"
#include "verification/compare/body_outcomes.h"
#include "verification/compare/missed_events.h"
#include "verification/compare/second_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wetfront::verification {
namespace {

/// Rain of 2 per second of which 0.5 per second runs off from `ponding` on, in steps of one second.
std::vector<meshes::LedgerRow> ledger_with_ponding(double ponding, int steps) {
  std::vector<meshes::LedgerRow> ledger;
  for (int t = 0; t <= steps; ++t) {
    meshes::LedgerRow row;
    row.time = t;
    row.rain_asked = 2 * t;
    row.run_off = 0.5 * std::max(0.0, t - ponding);
    row.infiltrated = row.rain_asked - row.run_off;
    ledger.push_back(row);
  }
  return ledger;
}

TEST(Events, PondingIsFoundInsideAStep) {
  EXPECT_NEAR(ponding_time(ledger_with_ponding(3.4, 10)), 3.4, 1e-12);
  EXPECT_TRUE(std::isnan(ponding_time(ledger_with_ponding(99, 10))));
  EXPECT_TRUE(std::isnan(ponding_time({})));
}

TEST(Events, ArrivalAndRiseOfALinearGauge) {
  meshes::Gauge gauge;
  for (int t = 0; t <= 20; ++t) {
    gauge.time.push_back(t);
    gauge.pressure.push_back(-1000 + 500 * t);
  }
  EXPECT_NEAR(crossing_time(gauge, arrival_pressure), 2.4, 1e-12);
  EXPECT_NEAR(rise_rate(gauge, 10000), 0.05, 1e-12);
}

TEST(Events, AGaugeThatStartsWetHasNoArrival) {
  meshes::Gauge gauge;
  gauge.time = {0, 1, 2};
  gauge.pressure = {500, 400, 300};
  EXPECT_TRUE(std::isnan(crossing_time(gauge, arrival_pressure)));
  EXPECT_TRUE(std::isnan(rise_rate(gauge, 10000)));
}

TEST(Events, LedgerIsLinearBetweenSteps) {
  const auto ledger = ledger_with_ponding(99, 10);
  EXPECT_DOUBLE_EQ(ledger_at(ledger, &meshes::LedgerRow::rain_asked, 2.5), 5);
  EXPECT_DOUBLE_EQ(ledger_at(ledger, &meshes::LedgerRow::rain_asked, 1e9), 20);
}

/// A marker that creeps a metre in 100 s, until failure, and slides another one in 10 s.
TEST(Events, ASlideLastsFromFailureOn) {
  mpm::Rider marker;
  marker.name = "D";
  for (int t = 0; t <= 120; ++t) {
    marker.time.push_back(t);
    marker.place.push_back({t <= 100 ? 0.01 * t : 1 + 0.1 * std::min(10, t - 100), 0, 0});
    marker.velocity.push_back({0, 0, 0});
  }
  mpm::BodyRecord body;
  body.riders = {marker};
  body.stages = {{"rain", "", 0, 100, "failure", ""}, {"slide", "", 100, 120, "rest", ""}};
  const auto found = body_outcomes(Scene{}, {}, body);
  EXPECT_NEAR(value_of(found, "largest_displacement"), 2, 1e-12);
  EXPECT_NEAR(value_of(found, "slide_duration"), 9, 1);  // rows are one second apart
}

/// A skin comes off first and the whole layer of a metre follows: shallow at failure, deep at the end.
TEST(Events, ASkinThatComesOffFirstIsAShallowFailure) {
  Scene scene;
  scene.geometry.shape = GroundProfile{{{0, 10}, {1, 1}}, {{0, 10}, {0, 0}}, 10, 2};
  mpm::Picture failure, rest;
  for (double x = 0.5; x < 10; ++x)
    for (const double y : {0.1, 0.5, 0.9}) {
      failure.displacement.push_back({y > 0.8 ? 0.1 : 0.001, 0, 0});
      rest.displacement.push_back({y > 0.3 ? 1.0 : 0, 0, 0});
      failure.snapshot.points.position.push_back({x + failure.displacement.back()[0], y, 0});
      rest.snapshot.points.position.push_back({x + rest.displacement.back()[0], y, 0});
    }
  failure.of = "failure";
  rest.of = "rest";
  mpm::BodyRecord body;
  body.pictures = {failure, rest};
  const auto found = body_outcomes(scene, {}, body);
  EXPECT_NEAR(value_of(found, "failure_depth"), 0.1, 1e-12);
  EXPECT_NEAR(value_of(found, "slide_depth"), 0.5, 1e-12);
  EXPECT_EQ(in_words(*find_outcome(found, "failure_depth")), "shallow");
  EXPECT_EQ(in_words(*find_outcome(found, "slide_depth")), "deep");
}

TEST(MissedEvents, AreTheShareThatDidNotCome) {
  Scene scene;
  scene.stages.resize(3);
  scene.stages[0].name = "rain";
  scene.stages[0].event.kind = StageEvent::Kind::failure;
  scene.stages[1].name = "slide";
  scene.stages[1].event.kind = StageEvent::Kind::rest;
  mpm::BodyRecord body;
  body.stages.resize(2);
  body.stages[0].name = "rain";
  body.stages[0].ended_by = "failure";
  body.stages[1].name = "slide";
  body.stages[1].ended_by = "time";
  ASSERT_EQ(missed_events(scene, body).size(), 1u);
  EXPECT_DOUBLE_EQ(missed_events(scene, body)[0].error, 0.5);
  EXPECT_EQ(missed_events(scene, body)[0].explanation, "rest in stage 'slide'");
  body.stages[1].ended_by = "rest";
  EXPECT_EQ(missed_events(scene, body)[0].error, 0);
  scene.stages.resize(0);
  EXPECT_TRUE(missed_events(scene, body).empty());
}

TEST(SecondMesh, TellsFailureApart) {
  const double never = std::nan("");
  EXPECT_TRUE(failure_on_two_meshes(never, never, "").empty());
  const auto both = failure_on_two_meshes(100, 103, "on half the cell size");
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].quantity, "failure_time_mesh");
  EXPECT_NEAR(both[0].error, 0.03, 1e-12);
  EXPECT_NEAR(failure_on_two_meshes(100, 97, "")[0].error, 0.03, 1e-12);
  const auto here = failure_on_two_meshes(100, never, "on half the cell size");
  EXPECT_EQ(here[0].error, 1);
  EXPECT_EQ(here[0].explanation, "it fails at 100 s here, and does not fail on half the cell size");
  EXPECT_EQ(failure_on_two_meshes(never, 100, "")[0].error, 1);
}

}  // namespace
}  // namespace wetfront::verification
