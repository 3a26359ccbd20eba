/// A layer sheared by a traction on its surface, as a scene says it: tau = G gamma, and pressed by its other component.
#include "mpm/simulation.h"
#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numeric>

namespace wetfront::verification {
namespace {

constexpr double young = 10e6, poisson = 0.3, height = 0.5;
constexpr double shear = young / (2 * (1 + poisson));
constexpr double constrained = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));

/// Without weight, its left and right sides one, its base held.
std::string layer(const std::string& top) {
  return R"(# a test
title = "a sheared layer"
requirement = "tau = G gamma"
gravity = ["0 m/s2", "0 m/s2"]
[geometry]
box = { size = ["0.5 m", "0.5 m"], cells = [5, 5] }
[[soil]]
name = "sand"
porosity = 0.4
young = "10 MPa"
poisson = 0.3
[[boundary]]
side = "base"
skeleton = "fixed"
[[boundary]]
side = "left"
skeleton = "periodic"
partner = "right"
[[boundary]]
side = "top"
)" + top +
         R"(
[[stage]]
name = "pushed"
until = "4 s"
skeleton = "quasi-static"
largest_step = "1 s"
[comparison]
times = ["1 s", "4 s"]
)";
}

struct Sheared {
  double strain_at_1 = 0, strain = 0, settlement = 0;  ///< of the surface
  double tau = 0, sigma = 0;                           ///< mean stresses xy, yy
};

Sheared moved_by(const std::string& top) {
  const auto path =
      std::filesystem::path(testing::TempDir()) / ("wetfront_traction_" + std::to_string(getpid()) + ".toml");
  std::ofstream(path) << layer(top);
  const Scene scene = read_scene(path);
  std::filesystem::remove(path);
  const meshes::Mesh mesh = mpm_mesh(scene);
  mpm::Simulation<2> simulation(to_mpm(scene, mesh, timeline(scene)));
  while (!simulation.finished()) simulation.step();
  const mpm::State end = simulation.state();
  const auto corner = static_cast<std::size_t>(mesh.side("top").faces.front());
  Sheared out;
  out.strain_at_1 = end.history.snapshots.at(0).node_displacement[corner][0] / height;
  out.strain = end.history.snapshots.at(1).node_displacement[corner][0] / height;
  out.settlement = -end.history.snapshots.at(1).node_displacement[corner][1] / height;
  const auto& stress = end.fields.at("point.stress");
  const auto points = static_cast<long>(stress.size() / 4);
  out.tau = std::accumulate(stress.begin() + 3 * points, stress.end(), 0.0) / static_cast<double>(points);
  out.sigma = std::accumulate(stress.begin() + points, stress.begin() + 2 * points, 0.0) / static_cast<double>(points);
  return out;
}

TEST(TractionOfAScene, ShearsALayerByItsModulusAndPressesIt) {
  const Sheared layer = moved_by(R"(traction = ["6 kPa", "-10 kPa"])");
  // The relaxation leaves 1e-4 of the forces, strains of a thousandth (10 kPa/M) as much.
  EXPECT_NEAR(layer.strain / (6e3 / shear), 1, 2e-3);
  EXPECT_NEAR(layer.settlement / (10e3 / constrained), 1, 3e-3);
  EXPECT_NEAR(layer.tau / 6e3, 1, 2e-3);
  EXPECT_NEAR(layer.sigma / -10e3, 1, 2e-3);
}

TEST(TractionOfAScene, FollowsItsRecord) {
  const Sheared layer = moved_by(R"(traction = [["0 s", "0 kPa", "0 kPa"], ["2 s", "6 kPa", "0 kPa"]])");
  EXPECT_NEAR(layer.strain_at_1 / (3e3 / shear), 1, 2e-3);
  EXPECT_NEAR(layer.strain / (6e3 / shear), 1, 2e-3);
}

TEST(TractionOfAScene, ActsBesideALoad) {
  const Sheared layer = moved_by("load = \"10 kPa\"\ntraction = [\"6 kPa\", \"4 kPa\"]");
  EXPECT_NEAR(layer.tau / 6e3, 1, 2e-3);
  EXPECT_NEAR(layer.sigma / -6e3, 1, 3e-3);
}

}  // namespace
}  // namespace wetfront::verification
