// A water table along a line: what both solvers start from, and what the page says of it.
#include "verification/present/tables.h"
#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"
#include "verification/translate/to_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// A groundwater table across a levee, known at three wells: the same pressures for both solvers.
TEST(WaterTable, MayBeALine) {
  const Setting wells{
      "initial.hydrostatic",
      R"({ water_table = [["2 m", "180 cm"], ["6 m", "1 m"], ["12 m", "0.4 m"]], suction_cap = "5 kPa" })"};
  const Scene scene =
      read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/levee/scene.toml", {wells});
  const auto by_hand = [](double x, double y) {
    const double table = x < 2 ? 1.8 : x < 6 ? 1.8 - 0.2 * (x - 2) : x < 12 ? 1 - 0.1 * (x - 6) : 0.4;
    return std::max(9810 * (table - y), -5000.0);
  };
  const mpm::Problem<2> candidate = to_mpm(scene, mpm_mesh(scene), timeline(scene));
  const fem::RichardsProblem reference = to_reference(scene, timeline(scene), {14, 0, 1e-4});
  ASSERT_EQ(reference.initial_head.size(), reference.mesh.node_count());
  double highest = 0, lowest = 0;
  for (std::size_t i = 0; i < reference.mesh.node_count(); ++i) {
    const auto& at = reference.mesh.nodes[i];
    EXPECT_NEAR(reference.initial_head[i] * 9810, by_hand(at[0], at[1]), 1e-3) << at[0] << " " << at[1];
  }
  for (std::size_t i = 0; i < candidate.mesh.node_count(); ++i) {
    const auto& at = candidate.mesh.nodes[i];
    EXPECT_NEAR(candidate.initial_pressure[i], by_hand(at[0], at[1]), 1e-3) << at[0] << " " << at[1];
    highest = std::max(highest, candidate.initial_pressure[i]);
    lowest = std::min(lowest, candidate.initial_pressure[i]);
  }
  EXPECT_NEAR(highest, 9810 * 1.8, 1e-3) << "level before the first well";
  EXPECT_EQ(lowest, -5000) << "capped";
  EXPECT_THAT(setup_table(scene, timeline(scene)).rows,
              testing::Contains(testing::Contains(
                  testing::HasSubstr("hydrostatic over a water table along a line from 1.8 m to 0.4 m"))));
}

}  // namespace
}  // namespace wetfront::verification
