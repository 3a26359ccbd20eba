/// What the solvers are given of scenes with layers, zones, parts of sides, weather, levels and starts of other kinds.
#include "reports/write.h"
#include "verification/present/contours.h"
#include "verification/present/field_files.h"
#include "verification/present/plan_text.h"
#include "verification/run/provenance.h"
#include "verification/run/scene_record.h"
#include "verification/scene/read.h"
#include "verification/translate/former_field.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/lay_soils.h"
#include "verification/translate/mpm_lacks.h"
#include "verification/translate/mpm_sides.h"
#include "verification/translate/mpm_soil.h"
#include "verification/translate/reference_sides.h"
#include "verification/translate/reference_soil.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"
#include "verification/translate/to_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

Scene case_scene(const std::string& name) {
  return read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases" / ("reference_" + name) /
                    "scene.toml");
}

double area_of(const meshes::Mesh& mesh, const std::string& region) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region_names[mesh.region[c]] == region) sum += mesh.cell_measure(c);
  return sum;
}

double length_of(const meshes::Mesh& mesh, const std::string& side) {
  double sum = 0;
  const auto& faces = mesh.side(side).faces;
  for (std::size_t f = 0; f < faces.size(); f += 2) {
    const auto &a = mesh.nodes[faces[f]], &b = mesh.nodes[faces[f + 1]];
    sum += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return sum;
}

/// 1 m of sand below and a block of 3 m x 1 m: 8 m2 of 15; the surface less the strip.
TEST(Translate, LayersZonesAndPartsFillTheirPlaces) {
  const Scene scene = case_scene("dry_layers");
  for (const int halvings : {0, 1}) {
    const meshes::Mesh mesh = reference_mesh(scene, 30, halvings);
    EXPECT_NEAR(area_of(mesh, "Berino fine sand"), 8, 1e-9);
    EXPECT_NEAR(area_of(mesh, "Glendale clay loam"), 7, 1e-9);
    EXPECT_NEAR(length_of(mesh, "strip"), 3, 1e-9);
    EXPECT_NEAR(length_of(mesh, "top"), 2, 1e-9);
  }
}

/// The mesh follows the boundary wherever it lies: 0.37 m is no multiple of a cell.
TEST(Translate, LayersOfAColumnAreMetExactlyByBothMeshes) {
  Scene scene = case_scene("two_layer_column");
  scene.geometry.layers[0].bottom = Layer::Thickness{0.37};
  EXPECT_NEAR(area_of(reference_mesh(scene, 50, 0), "upper"), 0.37, 1e-12);
  const meshes::Mesh strip = mpm_mesh(scene);
  EXPECT_NEAR(area_of(strip, "upper") / length_of(strip, "top"), 0.37, 1e-9);
  EXPECT_EQ(reference_mesh(scene, 50, 1).cell_count(), 2 * reference_mesh(scene, 50, 0).cell_count());
}

/// 0.5 m of topsoil over 24 m: the line follows the surface.
TEST(Translate, AProfileHasItsAreaAndItsTopsoil) {
  const Scene scene = case_scene("rising_lake");
  const meshes::Mesh mesh = reference_mesh(scene, scene.reference->cells, 0);
  EXPECT_NEAR(area_of(mesh, "topsoil"), 12, 1e-9);
  EXPECT_NEAR(area_of(mesh, "topsoil") + area_of(mesh, "loam"), 6 * 3 + 12 * 6 + 6 * 9 - 24 * 2, 1e-9);
  EXPECT_NEAR(length_of(mesh, "shore"), 6 + std::hypot(6, 3), 1e-9);
}

TEST(Translate, RainUnderALevelAndEvaporationBecomeOneConditionPerSide) {
  const Scene scene = case_scene("rising_lake");
  const auto sides = reference_sides(scene, 9810);
  ASSERT_EQ(sides.size(), 3u);  // top, shore, left
  const auto& sky = std::get<fem::RainSide>(sides[0]);
  EXPECT_EQ(sky.side, "top");
  EXPECT_EQ(sky.rain.start.size(), 3u);
  EXPECT_NEAR(sky.evaporation.intensity.at(0), 4e-3 / 86400, 1e-15);
  EXPECT_DOUBLE_EQ(sky.minimum_head, -50);
  const auto& shore = std::get<fem::WaterLevelSide>(sides[1]);
  EXPECT_EQ(shore.level.value, (std::vector<double>{3.2, 3.2, 5.2}));
  EXPECT_EQ(shore.rain.start.size(), 3u);
  EXPECT_TRUE(std::get<fem::HeadSide>(sides[2]).total);
  const auto before = antecedent_sides(scene, 9810, {{0}, {1e-7}}, false);
  EXPECT_TRUE(std::get<fem::RainSide>(before[0]).evaporation.start.empty());
  EXPECT_EQ(std::get<fem::RainSide>(before[0]).rain.intensity, std::vector<double>{1e-7});
  EXPECT_EQ(std::get<fem::WaterLevelSide>(before[1]).level.value, std::vector<double>{3.2});
  EXPECT_EQ(std::get<fem::HeadSide>(before[2]).head, 3.2);
}

TEST(Translate, SoilsInHeadsAsTheyWerePrinted) {
  Scene scene = case_scene("two_layer_column");
  Soil& soil = scene.soils[0];
  fem::Soil out = reference_soil(scene, soil, 1);
  const auto& gardner = std::get<fem::ExponentialRetention>(out.retention);
  EXPECT_NEAR(gardner.alpha, 10, 1e-12);
  EXPECT_NEAR(gardner.theta_r, 0.06, 1e-15);
  EXPECT_NEAR(out.saturated_conductivity, 0.01 / 3600, 1e-18);
  soil.retention = Haverkamp{1.611e6, 3.96, 0.01, 0.1, 1};
  soil.permeability = PermeabilityLaw::haverkamp;
  soil.haverkamp = {1.175e6, 4.74, 0.01};
  soil.anisotropy = Anisotropy{4, 1, 4, std::acos(-1) / 6, {}};
  soil.elastic = Elastic{1e7, 0.25, {}};
  scene.reference->skeleton = ReferenceSettings::SkeletonStorage::effective_saturation;
  out = reference_soil(scene, soil, 2);
  // a is printed for centimetres: |psi| = a^(1/beta) cm gives Se = 1/2.
  const double half = std::pow(1.611e6, 1 / 3.96) / 100;
  EXPECT_NEAR(std::get<fem::HaverkampRetention>(out.retention).a / std::pow(half, 3.96), 1, 1e-12);
  EXPECT_NEAR(out.anisotropy[0], 4 * 0.75 + 0.25, 1e-12);
  EXPECT_NEAR(std::abs(out.anisotropy[3]), 3 * std::sqrt(3) / 4, 1e-12);
  EXPECT_NEAR(reference_soil(scene, soil, 1).anisotropy[0], 4 * 0.25 + 0.75, 1e-12);
  EXPECT_NEAR(out.oedometer_modulus, 1.2e7, 1);
  EXPECT_EQ(out.bishop, fem::Soil::Bishop::effective_saturation);
  soil.retention = TabulatedRetention{{0, 9810}, {1, 0.25}};
  const auto table = std::get<fem::TabulatedRetention>(reference_soil(scene, soil, 1).retention);
  EXPECT_EQ(table.head, (std::vector<double>{-1, 0}));
  EXPECT_NEAR(table.content[0], 0.1, 1e-15);
  EXPECT_NEAR(table.content[1], 0.4, 1e-15);
}

TEST(Translate, AFieldOfConductivitiesReachesTheCells) {
  Scene scene = case_scene("dry_layers");
  scene.soils[0].conductivity_field = PlaceTable{{{0, 0, 0}, {5, 0, 0}}, {2, 0.5}, false};
  const auto problem = to_reference(scene, timeline(scene), {30, 0, 1e-4});
  ASSERT_EQ(problem.conductivity_factor.size(), problem.mesh.cell_count());
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const bool sand = problem.mesh.region_names[problem.mesh.region[c]] == "Berino fine sand";
    const double expected = !sand ? 1 : problem.mesh.cell_centre(c)[0] < 2.5 ? 2 : 0.5;
    EXPECT_EQ(problem.conductivity_factor[c], expected) << c;
  }
}

TEST(Translate, AWaterTableMayFollowTheBase) {
  const Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/moriwaki_flume/start_over_base.toml");
  const meshes::Mesh mesh = mpm_mesh(scene);
  const std::vector<double> p = initial_pressure(scene, mesh);
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    const double x = mesh.nodes[i][0], y = mesh.nodes[i][1];  // the base rises by 30 degrees from (11.90885, 1.04189)
    if (x < 12 || x > 20) continue;
    const double over = y - 1.04189 - (x - 11.90885) * std::tan(std::acos(-1.0) / 6);
    EXPECT_NEAR(p[i], std::max(-1000 * 9.81 * over, -1e4), 0.2) << x << " " << y;
  }
}

TEST(Translate, APressurePerSoilIsTheirMeanBetweenThem) {
  Scene scene = case_scene("two_layer_column");
  scene.initial->pressure = SoilStart{{{"upper", -1000}, {"lower", -3000}}};
  const meshes::Mesh mesh = reference_mesh(scene, 10, 0);
  const auto pressure = initial_pressure(scene, mesh);
  for (std::size_t i = 0; i < mesh.node_count(); ++i)
    EXPECT_EQ(pressure[i], mesh.nodes[i][0] < 0.99 ? -3000 : mesh.nodes[i][0] < 1.01 ? -2000 : -1000);
}

/// Written by reports, read back, put on another mesh: a linear field stays what it is.
TEST(Translate, AFormerRunHandsItsFieldOver) {
  const Scene scene = case_scene("dry_layers");
  meshes::FieldHistory history;
  history.mesh = reference_mesh(scene, 30, 0);
  meshes::Snapshot snapshot;
  snapshot.time = 7200;
  for (const auto& node : history.mesh.nodes) snapshot.node_pressure.push_back(100 * node[0] - 9810 * node[1]);
  history.snapshots = {snapshot};
  const auto folder = std::filesystem::path(testing::TempDir()) / ("wetfront_former_" + std::to_string(getpid()));
  reports::write_fields(field_files(history, "reference"), folder);
  const FormerField former = read_former_field(folder / "fields/reference_grid_0000.vtu");
  const meshes::Mesh other = reference_mesh(scene, 23, 0);
  const auto values = former.at_nodes(other);
  for (std::size_t i = 0; i < other.node_count(); ++i)
    EXPECT_NEAR(values[i], 100 * other.nodes[i][0] - 9810 * other.nodes[i][1], 1e-6);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(read_former_field(folder / "none.vtu"), std::runtime_error);
}

TEST(Translate, WhatTheMpmLacksIsSaidWhereItStands) {
  const Scene lake = case_scene("rising_lake");
  const auto messages = mpm_lacks(lake);
  EXPECT_THAT(messages, testing::ElementsAre(
                            testing::AllOf(testing::HasSubstr("scene.toml:"), testing::HasSubstr("has no scheme"))));
  EXPECT_THROW(to_mpm(lake, mpm_mesh(lake), timeline(lake)), SceneError);
  EXPECT_THAT(mpm_lacks(case_scene("rained_cube")), testing::Contains(testing::HasSubstr("is three-dimensional")));
  EXPECT_TRUE(mpm_lacks(case_scene("spin_up")).empty());
}

/// The same sides and soils as the reference is given, in pressures.
TEST(Translate, TheMpmIsGivenSidesAndSoilsInPressures) {
  const Scene lake = case_scene("rising_lake");
  const auto sides = mpm_sides(lake);
  ASSERT_EQ(sides.size(), 3u);  // top, shore, left
  const auto& sky = std::get<mpm::RainSide>(sides[0]);
  EXPECT_EQ(sky.side, "top");
  EXPECT_NEAR(sky.evaporation.intensity.at(0), 4e-3 / 86400, 1e-15);
  EXPECT_NEAR(sky.least_pressure, -50 * 9810, 1e-9);
  const auto& shore = std::get<mpm::WaterLevelSide>(sides[1]);
  EXPECT_EQ(shore.level.value, (std::vector<double>{3.2, 3.2, 5.2}));
  EXPECT_EQ(shore.rain.start.size(), 3u);
  EXPECT_EQ(std::get<mpm::TotalHeadSide>(sides[2]).head.value, (std::vector<double>{3.2, 3.2, 5.2}));

  Scene scene = case_scene("two_layer_column");
  Soil& soil = scene.soils[0];
  EXPECT_NEAR(std::get<mpm::ExponentialRetention>(*mpm_soil(scene, soil).retention).suction_scale, 981, 1e-9);
  soil.retention = Haverkamp{1.611e6, 3.96, 0.01, 0.1, 1};
  soil.anisotropy = Anisotropy{4, 1, 4, std::acos(-1) / 6, {}};
  const mpm::Soil out = mpm_soil(scene, soil);
  const double half = 98.1 * std::pow(1.611e6, 1 / 3.96);  // a is printed for centimetres
  EXPECT_NEAR(std::get<mpm::HaverkampRetention>(*out.retention).a / std::pow(half, 3.96), 1, 1e-12);
  const fem::Soil reference = reference_soil(scene, soil, 2);
  for (const int component : {0, 1, 3})
    EXPECT_NEAR(out.anisotropy[component], reference.anisotropy[component], 1e-12) << component;
}

/// 0.3 of the topmost of 40 cells is filled: the grid is higher than the ground, whose line cuts that row.
TEST(Translate, ASurfaceInsideCellsLiesBelowTheTopOfTheGrid) {
  Scene scene = case_scene("two_layer_column");
  scene.geometry.layers.clear();
  const double height = std::get<Column>(scene.geometry.shape).height;
  const int cells = std::get<Column>(scene.geometry.shape).cells;
  EXPECT_TRUE(surface_inside_cells(scene).empty());
  scene.mpm.surface_in_cell = 0.3;
  const meshes::Mesh mesh = mpm_mesh(scene);
  double top = 0;
  for (const auto& node : mesh.nodes) top = std::max(top, node[1]);
  EXPECT_NEAR((height - (cells - 1) * top / cells) / (top / cells), 0.3, 1e-9);
  const auto line = surface_inside_cells(scene);
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[1][1], height);
  EXPECT_EQ(std::get<mpm::RainSide>(mpm_sides(scene)[0]).side, mpm::free_surface);
}

/// Softer water is the MPM's own choice, which the reference must not follow: else no comparison would show its cost.
TEST(Translate, SoftenedWaterIsTheMpmsAlone) {
  Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column/scene_3e-5.toml");
  const auto modulus = [&] { return to_mpm(scene, mpm_mesh(scene), timeline(scene)).water->bulk_modulus; };
  const auto storage = [&] { return reference_soil(scene, scene.soils[0], 2).specific_storage; };
  const double before = modulus(), stored = storage();
  scene.mpm.water_softening = 0.1;
  EXPECT_NEAR(modulus(), 0.1 * before, 1e-6 * before);
  EXPECT_EQ(storage(), stored);
  scene.soils[0].specific_storage = 1e-4;
  EXPECT_NEAR(*mpm_soil(scene, scene.soils[0]).storage, 10 * 1e-4 / 9810, 1e-12)
      << "storage that the scene gives is softened, too";
}

TEST(PlanText, TellsWhatThePointsTakeInAllAndEach) {
  mpm::PlanInfo plan;
  plan.points = 100;
  plan.slots = 125;
  plan.bytes_per_point = 16;
  plan.point_bytes = 2000;
  EXPECT_THAT(plan_text({plan}),
              testing::HasSubstr("100 points in 125 slots of 16 bytes: 0.002 MB, 20.0 bytes per point"));
}

TEST(SceneRecord, SaysHowManyThreadsTheKernelsHad) {
  Scene scene = case_scene("dry_layers");
  const meshes::Mesh mesh = reference_mesh(scene, 20, 0);
  EXPECT_EQ(record_of(scene, mesh).provenance.at("threads"), "1");
  scene.mpm.threads = 2;
  EXPECT_EQ(record_of(scene, mesh).provenance.at("threads"), "2");
  meshes::FieldHistory reference;
  EXPECT_EQ(threads_of_reference(reference), "1");
  reference.counters["ranks"] = 3;
  EXPECT_EQ(threads_of_reference(reference), "1 on each of 3 ranks");
}

/// Circles of a paraboloid, cut by the edge of the square: each piece is closed or ends on the edge.
TEST(Contours, FollowTheirLevel) {
  Scene scene = case_scene("dry_layers");
  scene.geometry.shape = Box{{2, 2}, {20, 20}};
  scene.geometry.layers.clear();
  scene.geometry.zones.clear();
  scene.geometry.parts.clear();
  const meshes::Mesh mesh = reference_mesh(scene, 20, 0);
  std::vector<double> nodal;
  for (const auto& node : mesh.nodes) nodal.push_back(std::hypot(node[0] - 1, node[1] - 1));
  const reports::Series circle = contour(mesh, nodal, 0.5);
  ASSERT_GT(circle.x.size(), 40u);
  for (std::size_t i = 0; i < circle.x.size(); ++i)
    EXPECT_NEAR(std::hypot(circle.x[i] - 1, circle.y[i] - 1), 0.5, 0.01);  // straight chords in cells of 0.1: h^2/8R
  EXPECT_EQ(circle.x.front(), circle.x.back());
  EXPECT_EQ(outline(mesh).x.size(), 81u);
  EXPECT_EQ(round_levels(-3.2, 4.1, 6), (std::vector<double>{-2, 0, 2, 4}));
}

}  // namespace
}  // namespace wetfront::verification
