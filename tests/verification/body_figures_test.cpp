#include "verification/present/body_figures.h"

#include "meshes/mesh.h"
#include "reports/film.h"
#include "verification/present/body_film.h"
#include "verification/present/slide_figures.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// Two square cells side by side, one metre each, with a body whose skeleton deforms.
meshes::FieldHistory history() {
  meshes::FieldHistory made;
  made.mesh.dim = 2;
  made.mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  made.mesh.cells = {0, 1, 4, 3, 1, 2, 5, 4};
  made.mesh.region = {0, 0};
  meshes::Snapshot snapshot;
  snapshot.node_displacement.resize(6);
  for (double x = 0.1; x < 2; x += 0.2)
    for (double y = 0.1; y < (x < 1 ? 1 : 0.5); y += 0.2) snapshot.points.position.push_back({x, y, 0});
  made.snapshots = {snapshot};
  return made;
}

TEST(BodyFigures, OutlineIsTheHighestPointOfEachStretch) {
  const auto figures = body_figures(history());
  ASSERT_EQ(figures.size(), 1u);
  ASSERT_EQ(figures[0].series.size(), 2u);  // the points, and one outline
  EXPECT_EQ(figures[0].series[0].x.size(), history().snapshots[0].points.position.size());
  const reports::Series& outline = figures[0].series[1];
  ASSERT_EQ(outline.y.size(), 2u);
  EXPECT_NEAR(outline.y[0], 0.9, 1e-12);
  EXPECT_NEAR(outline.y[1], 0.3, 1e-12);  // stretches begin at the leftmost point
}

/// The same column on its base and, without one, fallen onto the end of its mesh.
TEST(HeldPoints, AreToldWhereABodyMeetsTheEndOfItsMesh) {
  Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases" / "dry_column" / "scene.toml");
  const auto told = [&scene] {
    const reports::Record record = run_prepared(prepare(scene)).record;
    const auto finding = std::ranges::find(record.findings, "held_points", &reports::Finding::quantity);
    const bool logged = std::ranges::any_of(
        record.log, [](const std::string& line) { return line.find("held at its border") != std::string::npos; });
    EXPECT_EQ(finding != record.findings.end(), logged);
    if (!logged) return 0.0;
    EXPECT_EQ(finding->verdict, reports::Verdict::info);
    return finding->error;
  };
  EXPECT_EQ(told(), 0);
  std::erase_if(scene.boundaries, [](const Boundary& boundary) { return boundary.side == "base"; });
  EXPECT_GT(told(), 0);
}

TEST(BodyFigures, AreNotThereForARigidSkeleton) {
  meshes::FieldHistory rigid = history();
  rigid.snapshots[0].node_displacement.clear();
  EXPECT_TRUE(body_figures(rigid).empty());
}

/// A compared field before failure is a frame while its points keep their cells, and none once they may have changed
/// order.
TEST(BodyFilms, BeginUnderTheRain) {
  meshes::FieldHistory run = history();
  meshes::Snapshot rain = run.snapshots[0];
  const auto moved = [&rain](double time, double by) {
    meshes::Snapshot one = rain;
    one.time = time;
    for (meshes::Point& place : one.points.position) place[0] += by;
    return one;
  };
  run.snapshots = {moved(1, 0.05), moved(2, 0.3)};
  mpm::BodyRecord body;
  for (const double time : {3.0, 4.0}) {
    mpm::Picture picture{moved(time, 0.1 * time), time == 3 ? "failure" : "rest", {}};
    picture.displacement.assign(rain.points.position.size(), {0.1 * time, 0, 0});
    body.pictures.push_back(picture);
  }
  const auto films = body_films(Scene{}, run, body);
  ASSERT_EQ(films.size(), 1u);
  ASSERT_EQ(films[0].frames.size(), 3u);
  EXPECT_EQ(films[0].frames[0].time, 1);
  EXPECT_NEAR(reports::film_value(films[0], 0, 2, 0), 0.05, 1e-4);
  EXPECT_EQ(films[0].frames[1].label, "failure");
}

/// What is known, what came out, and what came out on the second mesh stand in one row.
TEST(SlideTables, ASecondMeshStandsBesideWhatCameOut) {
  Scene scene;
  scene.observations = {{"failure_time", "9267 s", "", "late", {}}, {"largest_velocity", "", "", "", {}}};
  const std::vector<Outcome> outcomes = {{"failure_time", "time of failure", "s", 11004.0}};
  const std::optional<OnSecondMesh> second{
      {"on twice the cell size", {{"failure_time", "time of failure", "s", 10951}}}};
  const reports::Table one = observed_table(scene, outcomes, {}), two = observed_table(scene, outcomes, second);
  ASSERT_EQ(one.header.size(), 6u);
  ASSERT_EQ(two.header.size(), 8u);
  EXPECT_EQ(two.header[4], "on twice the cell size");
  const std::vector<std::string> row = {"time of failure",
                                        "9267 s",
                                        "-",
                                        "11004 s",
                                        "10951 s",
                                        "53 s, 0.48 %",
                                        "here 19 % later than measured; the two meshes differ by 0.48 %",
                                        "late"};
  EXPECT_EQ(two.rows[0], row);
  EXPECT_EQ(two.rows[1][4], "-");  // neither mesh has it
  EXPECT_EQ(outcome_table(outcomes, second).rows[0].back(), "53 s, 0.48 %");
}

}  // namespace
}  // namespace wetfront::verification
