// The infinite slope beside a run's factor of safety: weights, pressures and strengths of a scene at a place.
#include "verification/compare/slope_factors.h"

#include "verification/exact/infinite_slope.h"
#include "verification/translate/scene_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180, angle = 20 * degree, thickness = 1.5, g = 9.81;

Scene slope() {
  Scene scene;
  scene.geometry.shape = Slope{6, thickness, angle, 12, 6};
  scene.water = Water{};
  Soil soil{};
  soil.name = "sand";
  soil.porosity = 0.4;
  soil.grain_density = 2650;
  soil.intrinsic_permeability = 1e-11;
  soil.retention = VanGenuchten{4000, 0.5, 0.2, 1};
  soil.elastic = Elastic{1e7, 0.3, {}};
  soil.strength = Strength{};
  soil.strength->peak = {34 * degree, 0, 0, {}};
  scene.soils = {soil};
  return scene;
}

/// `pressure` over vertical depth [m] at every node.
template <class Pressure>
meshes::Snapshot snapshot(const meshes::Mesh& mesh, const Pressure& pressure, double saturation) {
  meshes::Snapshot at;
  for (const meshes::Point& node : mesh.nodes)
    at.node_pressure.push_back(pressure(thickness + node[0] * std::tan(angle) - node[1]));
  at.node_saturation.assign(mesh.nodes.size(), saturation);
  return at;
}

/// Water that flows along the slope: (gamma - gamma_w)/gamma of the dry factors at any depth.
TEST(SlopeFactors, AFullSlopeBearsByItsBuoyantWeight) {
  const Scene scene = slope();
  const meshes::Mesh mesh = mpm_mesh(scene);
  const double cosine = std::cos(angle);
  const auto found = slope_factors(scene, mesh,
                                   snapshot(
                                       mesh, [&](double depth) { return 1000 * g * depth * cosine * cosine; }, 1));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place, 3, 1e-12);
  EXPECT_NEAR(found->angle, angle, 1e-12);
  const double dry = 0.6 * 2650, full = dry + 0.4 * 1000, buoyant = (full - 1000) / full;
  // 1e-5: pressures are taken a hair above where a slice ends.
  EXPECT_NEAR(found->limit, buoyant * std::tan(34 * degree) / std::tan(angle), 1e-5);
  EXPECT_NEAR(found->davis, buoyant * std::sin(34 * degree) / std::tan(angle), 1e-5);
}

/// With cohesion the base is weakest; suction counts by Bishop's parameter, and in the cohesion of Yerro's law.
TEST(SlopeFactors, SuctionAndCohesionAtTheBase) {
  Scene scene = slope();
  const double suction = 5000, saturation = 0.6;
  scene.soils[0].strength->peak.cohesion = 1000;
  const meshes::Mesh mesh = mpm_mesh(scene);
  const auto dry = snapshot(
      mesh, [&](double) { return -suction; }, saturation);
  const double weight = (0.6 * 2650 + 0.4 * saturation * 1000) * g * thickness;
  const auto wanted = [&](double chi, double cohesion) {
    const exact::PlaneLoad load{weight * std::cos(angle) * std::cos(angle), weight * std::cos(angle) * std::sin(angle),
                                -chi * suction};
    return exact::limit_safety(load, {34 * degree, 0, cohesion});
  };
  const auto found = slope_factors(scene, mesh, dry);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->limit, wanted(saturation, 1000), 1e-5);
  EXPECT_NEAR(found->limit_depth, thickness, 1e-9);
  scene.soils[0].bishop = Bishop::effective_saturation;
  EXPECT_NEAR(slope_factors(scene, mesh, dry)->limit, wanted(0.5, 1000), 1e-5);
  Strength& law = *scene.soils[0].strength;
  law.law = Strength::Law::suction;
  law.suction_cohesion = 3000;
  law.cohesion_rate = 5;
  const double more = 3000 * (1 - std::exp(-5 * 0.5 * suction / 100e3));
  EXPECT_NEAR(slope_factors(scene, mesh, dry)->limit, wanted(0.5, 1000 + more), 1e-5);
}

TEST(SlopeFactors, NothingWithoutASlopeOrStrength) {
  Scene scene = slope();
  const meshes::Mesh mesh = mpm_mesh(scene);
  const auto wet = snapshot(
      mesh, [](double) { return 0.0; }, 1);
  scene.soils[0].strength.reset();
  EXPECT_FALSE(slope_factors(scene, mesh, wet));
  scene = slope();
  scene.geometry.shape = Box{{6, 1.5}, {12, 6}};
  EXPECT_FALSE(slope_factors(scene, mesh, wet));
}

}  // namespace
}  // namespace wetfront::verification
