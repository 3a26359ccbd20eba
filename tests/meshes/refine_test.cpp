#include "meshes/refine.h"

#include "meshes/geo_script.h"
#include "meshes/gmsh.h"
#include "tests/meshes/total_measure.h"

#include <gtest/gtest.h>

namespace wetfront::meshes {
namespace {

TEST(Refine, HalvesQuadrilateralsAndTheirSides) {
  const Mesh coarse = generate(slope_script({10, 1.2, 0.5, 5, 2}), 2), fine = refined(coarse);
  EXPECT_NO_THROW(validate(fine));
  EXPECT_EQ(fine.cell_count(), 4 * coarse.cell_count());
  EXPECT_EQ(fine.node_count(), 11u * 5u);  // no edge's middle twice
  EXPECT_NEAR(total_measure(fine), total_measure(coarse), 1e-12);
  for (const Side& side : coarse.sides) EXPECT_EQ(fine.side(side.name).faces.size(), 2 * side.faces.size());
}

TEST(Refine, HalvesALine) {
  const Mesh fine = refined(generate(line_column_script(1.2, 4), 1));
  EXPECT_NO_THROW(validate(fine));
  EXPECT_EQ(fine.cell_count(), 8u);
  EXPECT_NEAR(total_measure(fine), 1.2, 1e-12);
}

TEST(Refine, KeepsRegions) {
  Mesh coarse = generate(slope_script({2, 1, 0, 2, 1}), 2);
  coarse.region_names = {"left", "right"};
  coarse.region = {0, 1};
  const Mesh fine = refined(coarse);
  for (std::size_t c = 0; c < fine.cell_count(); ++c) EXPECT_EQ(fine.region[c], fine.cell_centre(c)[0] > 1 ? 1 : 0);
}

}  // namespace
}  // namespace wetfront::meshes
