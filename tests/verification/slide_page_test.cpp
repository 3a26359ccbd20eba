/// What the page of a slide says beside its numbers: what is known, the doubt of two meshes, and where momentum went.
#include "verification/compare/measure.h"
#include "verification/present/flux_tables.h"
#include "verification/present/known.h"
#include "verification/present/motion_balance.h"
#include "verification/present/slide_figures.h"
#include "verification/present/surface_rain.h"
#include "verification/scene/known_value.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

/// A plane mesh of one rectangle, a metre high [m].
meshes::Mesh one_cell(double width) {
  meshes::Mesh mesh;
  mesh.dim = 2;
  mesh.nodes = {{0, 0, 0}, {width, 0, 0}, {0, 1, 0}, {width, 1, 0}};
  mesh.cells = {0, 1, 3, 2};
  mesh.region = {0};
  return mesh;
}

TEST(KnownValues, AreReadFromWords) {
  const auto one = number_in_words("about 6300 s", "s"), band = number_in_words("3 to 3.7 m", "m"),
             units = number_in_words("90 cm to 1.2 m", "m"), rate = number_in_words("3.4e-4 m/s", "m/s");
  ASSERT_TRUE(one && band && units && rate);
  EXPECT_EQ(one->low, 6300);
  EXPECT_EQ(one->high, 6300);
  EXPECT_EQ(band->low, 3);
  EXPECT_EQ(band->high, 3.7);
  EXPECT_DOUBLE_EQ(units->low, 0.9);
  EXPECT_DOUBLE_EQ(rate->low, 3.4e-4);
  for (const char* other : {"", "late", "6300 m", "4 to 3 s", "-3 s", "to 3 s", "3 to  s", "before 6300 s"})
    EXPECT_FALSE(number_in_words(other, "s")) << other;
}

TEST(KnownValues, DistanceIsFromTheNearerEnd) {
  const Band band{3, 4};
  EXPECT_EQ(relative_distance(3.5, band), 0);
  EXPECT_DOUBLE_EQ(relative_distance(1.5, band), 0.5);
  EXPECT_DOUBLE_EQ(relative_distance(6, band), 0.5);
  EXPECT_TRUE(std::isnan(relative_distance(std::nan(""), band)));
}

TEST(KnownValues, ASentenceTellsThem) {
  const Observation way{"largest_displacement", "3 to 3.7 m", "4.3 to 5 m", "", {}};
  const Outcome here{"largest_displacement", "", "m", 0.3}, second{"largest_displacement", "", "m", 0.09};
  EXPECT_EQ(in_a_sentence(way, &here, &second),
            "here 10 times less than measured, 14 times less than published; the two meshes differ by 70 %");
  EXPECT_EQ(difference_of_meshes(&here, &second), "0.21 m, 70 %");
  const Observation failure{"failure_time", "9267 s", "", "", {}};
  const Outcome late{"failure_time", "", "s", 11120.4}, never{"failure_time", "", "s", std::nan("")};
  EXPECT_EQ(in_a_sentence(failure, &late, nullptr), "here 20 % later than measured");
  EXPECT_EQ(in_a_sentence(failure, &late, &never),
            "here 20 % later than measured; on the second mesh it did not happen");
  EXPECT_EQ(in_a_sentence(failure, &never, &late), "it did not happen here");
  EXPECT_EQ(difference_of_meshes(&late, &never), "-");
  const Observation interval{"interval:G-9:G-5", "about 1000 s", "", "", {}};
  const Outcome turned{"interval:G-9:G-5", "", "s", -23.5};
  EXPECT_EQ(in_a_sentence(interval, &turned, nullptr), "here in the other order than measured");
  const Outcome right{"failure_time", "", "s", 9270};
  EXPECT_EQ(in_a_sentence(failure, &right, nullptr), "here as measured");
}

/// A scene with water of 10 kN/m3 and two probes, and what is known of them.
Scene known_scene() {
  Scene scene;
  scene.gravity = {0, -10, 0};
  scene.water = Water{};
  scene.probes = {{"A", {}, {}}, {"B", {}, {}}};
  scene.observations = {{"arrival_time:A", "about 100 s", "110 s", "", {}},
                        {"interval:A:B", "50 s", "", "", {}},
                        {"rise_rate:A", "1e-3 m/s", "", "", {}},
                        {"rise_rate:B", "2e-3 m/s", "4e-3 m/s", "", {}},
                        {"failure_time", "700 s", "", "", {}},
                        {"largest_displacement", "3 to 3.7 m", "5 m", "", {}}};
  return scene;
}

/// Two gauges that rise by 20 Pa/s: A from 100 s, B from 300 s.
meshes::FieldHistory rising() {
  meshes::FieldHistory history;
  for (const auto& [name, from] : {std::pair{"A", 100.0}, {"B", 300.0}}) {
    meshes::Gauge gauge;
    gauge.name = name;
    for (double t = 0; t <= 1000; t += 10) {
      gauge.time.push_back(t);
      gauge.pressure.push_back(20 * (t - from));
    }
    history.gauges.push_back(gauge);
  }
  return history;
}

const reports::Series* labelled(const reports::Figure& figure, const std::string& beginning) {
  for (const reports::Series& series : figure.series)
    if (series.label.starts_with(beginning)) return &series;
  return nullptr;
}

TEST(KnownLines, RisesBeginAtTheFirstRiseAndFailureStandsUpright) {
  reports::Figure figure;
  figure.series.push_back({"MPM, A", reports::Series::Style::line, {0, 1000}, {-2, 18}});
  draw_known_rises(figure, known_scene(), rising());
  const reports::Series *a = labelled(figure, "measured, A"), *b = labelled(figure, "measured, B"),
                        *published = labelled(figure, "published, B"), *failure = labelled(figure, "failure, measured");
  ASSERT_TRUE(a && b && published && failure);
  EXPECT_EQ(labelled(figure, "published, A"), nullptr);  // its rate is not known
  EXPECT_EQ(a->x[0], 100);
  EXPECT_NEAR((a->y[1] - a->y[0]) * 1000 / (a->x[1] - a->x[0]), 1e-3 * 10000, 1e-9);  // Pa/s
  EXPECT_EQ(b->x[0], 150);                  // by way of A and the time between
  EXPECT_NEAR(published->x[0], 310, 1e-9);  // neither is known of the simulation: where it rose here
  EXPECT_EQ(failure->x, (std::vector<double>{700, 700}));
  EXPECT_EQ(failure->y, (std::vector<double>{0, 18}));
}

TEST(KnownLines, WaysAreLevelLines) {
  reports::Figure figure;
  figure.series.push_back({"D-1", reports::Series::Style::line, {0, 6}, {0, 0.3}});
  draw_known_displacement(figure, known_scene());
  ASSERT_EQ(figure.series.size(), 3u);
  const reports::Series& measured = figure.series[1];
  ASSERT_EQ(measured.y.size(), 5u);
  EXPECT_EQ(measured.y[0], 3);
  EXPECT_EQ(measured.y[1], 3);
  EXPECT_TRUE(std::isnan(measured.y[2]));
  EXPECT_EQ(measured.y[3], 3.7);
  EXPECT_EQ(measured.x[4], 6);
  EXPECT_EQ(figure.series[2].y, (std::vector<double>{5, 5}));
  reports::Figure none;
  draw_known_displacement(none, Scene{});
  EXPECT_TRUE(none.series.empty());
}

/// A body that gains momentum from its weight, of which walls take a part, from 1000 s to 1004 s. Its first row is
/// written after the first cycles: impulses have begun.
meshes::FieldHistory sliding() {
  meshes::FieldHistory history;
  history.mesh.dim = 2;
  for (int k = 0; k <= 400; ++k) {
    const double t = 0.01 * k;
    meshes::MotionRow row;
    row.time = 1000 + t;
    row.kinetic = t;
    row.motion = 10;
    row.momentum = {1 + 2 * t, 0, 0};
    row.impulse = {1.5 + 3 * t, -5 - 10 * t, 0};
    row.reaction = {-0.5 - t, 5 + 10 * t, 0};
    history.motion.push_back(row);
    meshes::LedgerRow water;
    water.time = row.time;
    water.rain_asked = 5 + t;
    water.run_off = 0.25 * t;
    water.outflow = 2 + 0.5 * t;
    water.stored = 7 + 0.25 * t;
    history.ledger.push_back(water);
  }
  return history;
}

/// Comparison times before the slide have no row of its own: five of them once showed the same beginning.
TEST(MotionTable, HasTimesOfTheSlideWhereNoneAreCompared) {
  Timeline timeline;
  timeline.comparison_times = {100, 200, 300, 400, 500};
  const reports::Table table = motion_table(sliding(), timeline);
  std::vector<std::string> times;
  for (const auto& row : table.rows) times.push_back(row[1]);
  EXPECT_EQ(times, (std::vector<std::string>{"0", "0.1", "0.2", "0.5", "1", "2", "4"}));
  const auto column = std::ranges::find(table.header, "momentum gained [N s]") - table.header.begin();
  EXPECT_EQ(table.rows.back()[column], "8; 0");
  EXPECT_EQ(table.rows.back()[column + 1], "12; -40");
  EXPECT_EQ(table.rows.back()[column + 2], "-4; 40");
  timeline.comparison_times = {1001, 1002, 1003, 1004};
  EXPECT_EQ(motion_table(sliding(), timeline).rows.size(), 4u);
}

/// Fluxes are compared until failure: both end there, between rows of their ledgers, and say so.
TEST(FluxTables, EndWithFailure) {
  meshes::FieldHistory run = sliding();
  run.mesh = one_cell(2);
  run.sides = {{"top", "rain", {}, {}, {}, {}, {}}};
  for (const meshes::LedgerRow& row : run.ledger) run.sides[0].asked.push_back(row.rain_asked);
  Scene scene;
  Timeline window, planned;
  window.comparison_times = planned.comparison_times = {1001};
  window.stage_end = {1002.005};
  planned.stage_end = {1010};
  const auto cut = compared_fluxes(scene, window, 1002.005, run, run);
  ASSERT_EQ(cut.size(), 3u);
  for (const reports::Table& table : cut) {
    EXPECT_TRUE(table.title.ends_with(" until failure")) << table.title;
    EXPECT_NE(table.caption.find("the failure at 1002"), std::string::npos) << table.title;
    EXPECT_EQ(table.rows.size(), 2u) << table.title;
  }
  EXPECT_EQ(cut[0].rows[1][1], "3502.5000");  // 7.005 m2 over 2 m
  EXPECT_EQ(cut[1].rows[1][3], "7005.0000");
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(compared_fluxes(scene, planned, never, run, run)[0].title, "Water ledger of the reference");
  const auto own = ledger_of_run(scene, planned, 1002.005, run);
  ASSERT_EQ(own.rows.size(), 3u);
  EXPECT_EQ(own.rows[1], cut[0].rows[1]);  // to be held against each other
  EXPECT_EQ(own.rows[2][0], "1004");
}

/// What nodes above each other got is rain on one place, told per horizontal metre: 10 mm fell everywhere here, of
/// which the middle refused half.
TEST(SurfaceRain, IsToldPerHorizontalMetre) {
  meshes::FieldHistory run;
  run.mesh = one_cell(2);
  run.rain_by_node = {{0, {0, 0, 0}, 0.01, 0.01, 0},
                      {1, {2, 0, 0}, 0.015, 0.005, 0.01},
                      {2, {2, 1, 0}, 0.005, 0.005, 0},
                      {3, {4, 0, 0}, 0.01, 0.01, 0}};
  const auto figure = surface_rain_figure(run, std::numeric_limits<double>::infinity(), &run);
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->series.size(), 6u);
  EXPECT_EQ(figure->series[0].x, (std::vector<double>{0, 2, 4}));
  for (const double fallen : figure->series[0].y) EXPECT_NEAR(fallen, 10, 1e-12);
  EXPECT_NEAR(figure->series[1].y[1], 5, 1e-12);
  EXPECT_NEAR(figure->series[2].y[1], 5, 1e-12);
  const auto failed = surface_rain_figure(run, 100, &run);  // the reference's rain is that of another time
  ASSERT_TRUE(failed);
  EXPECT_EQ(failed->series.size(), 3u);
}

TEST(MotionFigures, ExplainMomentumAndWaterSinceFailure) {
  const auto all = motion_figures(sliding(), true);
  const auto figure = [&all](const std::string& id) {
    const auto found = std::ranges::find(all, id, &reports::Figure::id);
    return found == all.end() ? nullptr : &*found;
  };
  for (const char* id : {"kinetic_energy", "energy", "momentum_x", "momentum_y", "water_of_slide"}) {
    ASSERT_NE(figure(id), nullptr) << id;
    EXPECT_EQ(figure(id)->x_label, "time since failure");
    EXPECT_EQ(figure(id)->series[0].x.front(), 0) << id;
  }
  EXPECT_EQ(labelled(*figure("energy"), "kinetic"), nullptr);
  const reports::Series &gained = *labelled(*figure("momentum_x"), "gained"),
                        &sum = *labelled(*figure("momentum_x"), "sum");
  for (std::size_t k = 0; k < gained.y.size(); ++k) EXPECT_NEAR(gained.y[k], sum.y[k], 1e-12);
  EXPECT_NEAR(gained.y.back(), 8, 1e-12);
  EXPECT_NEAR(labelled(*figure("momentum_x"), "impulse of weight")->y.back(), 12, 1e-12);
  EXPECT_NEAR(labelled(*figure("momentum_x"), "impulse of walls")->y.back(), -4, 1e-12);
  const reports::Series &stored = *labelled(*figure("water_of_slide"), "stored"),
                        &balance = *labelled(*figure("water_of_slide"), "taken in less");
  EXPECT_NEAR(stored.y.back(), 1000, 1e-9);
  EXPECT_NEAR(balance.y.back(), 1000, 1e-9);
  EXPECT_EQ(motion_figures(sliding())[0].x_label, "time since the skeleton began to move");
}

/// Fourteen outlines of one slide cannot be told from each other.
TEST(SlideFigures, OutlinesAreFewAndEndWithTheRest) {
  meshes::FieldHistory history;
  history.mesh = one_cell(1);
  Scene scene;
  scene.geometry.shape = Slope{};
  mpm::BodyRecord body;
  for (int k = 0; k <= 20; ++k) {
    mpm::Picture picture;
    picture.snapshot.time = 100.0 * k;
    picture.snapshot.node_displacement.resize(4);
    picture.snapshot.points.position = {{0.5, 0.5, 0}};
    picture.of = k == 10 ? "failure" : k == 20 ? "rest" : "";
    picture.displacement = {{k <= 10 ? 0.0 : 0.1 * (k - 10), 0, 0}};
    body.pictures.push_back(picture);
  }
  const auto all = slide_figures(scene, history, body);
  const auto outline = std::ranges::find(all, "slide_outline", &reports::Figure::id);
  ASSERT_NE(outline, all.end());
  std::vector<std::string> labels;
  for (const reports::Series& series : outline->series) labels.push_back(series.label);
  EXPECT_EQ(labels, (std::vector<std::string>{"points, 2000 s", "1000 s", "1400 s", "1700 s", "2000 s"}));
}

}  // namespace
}  // namespace wetfront::verification
