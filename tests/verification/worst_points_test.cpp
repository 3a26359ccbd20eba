// Of a field that fails, the places that make the error; of fields that hold, nothing.
#include "verification/present/worst_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

constexpr std::size_t cells = 40;

/// A column of 40 cells of 0.1 m whose pressure is 1 kPa everywhere, but in some cells.
meshes::FieldHistory column(const std::vector<std::pair<std::size_t, double>>& other = {}) {
  meshes::FieldHistory made;
  made.mesh.dim = 2;
  for (std::size_t row = 0; row <= cells; ++row)
    for (const double x : {0.0, 0.1}) made.mesh.nodes.push_back({x, 0.1 * static_cast<double>(row), 0});
  for (int row = 0; row < static_cast<int>(cells); ++row)
    for (const int node : {2 * row, 2 * row + 1, 2 * row + 3, 2 * row + 2}) made.mesh.cells.push_back(node);
  made.mesh.region.assign(cells, 0);
  meshes::Snapshot snapshot;
  snapshot.time = 60;
  snapshot.node_pressure.assign(2 * cells + 2, 1000);
  snapshot.node_saturation.assign(2 * cells + 2, 0.5);
  snapshot.cell_pressure.assign(cells, 1000);
  snapshot.cell_saturation.assign(cells, 0.5);
  for (const auto& [cell, pressure] : other) snapshot.cell_pressure[cell] = pressure;
  made.snapshots = {snapshot};
  return made;
}

WorstPoints worst(reports::Verdict verdict, const std::string& quantity) {
  reports::Finding finding;
  finding.quantity = quantity;
  finding.description = "at 60 s";
  finding.verdict = verdict;
  Measurement measurement;
  measurement.quantity = quantity;
  measurement.description = "at 60 s";
  measurement.time_index = 0;
  // 3 kPa off in cell 7, 1 kPa off in cell 30: nine tenths and one tenth of the squared error.
  return worst_points({finding}, {measurement}, {column({{7, 4000}, {30, 2000}}), column()});
}

TEST(WorstPoints, AreRankedByTheirShareOfTheError) {
  const WorstPoints found = worst(reports::Verdict::fail, "pressure_l2");
  ASSERT_EQ(found.tables.size(), 1u);
  EXPECT_THAT(found.tables[0].title, testing::HasSubstr("pore pressure at 60 s"));
  EXPECT_THAT(found.tables[0].rows, testing::ElementsAre(testing::ElementsAre("0.05", "0.75", "4", "1", "3", "90.0"),
                                                         testing::ElementsAre("0.05", "3.05", "2", "1", "1", "10.0")));
  ASSERT_EQ(found.files.size(), 1u);
  EXPECT_EQ(found.files[0].stem, "worst_points");
  EXPECT_EQ(found.files[0].time, 60);
  EXPECT_THAT(found.files[0].nodes,
              testing::Pointwise(testing::DoubleNear(1e-12), std::vector<double>{0.05, 0.75, 0, 0.05, 3.05, 0}));
  EXPECT_EQ(found.files[0].fields[2].name, "pore_pressure_difference [Pa]");
  EXPECT_THAT(found.files[0].fields[2].values, testing::ElementsAre(3000, 1000));
}

TEST(WorstPoints, AreThereForFieldsThatFailOnly) {
  for (const auto verdict : {reports::Verdict::pass, reports::Verdict::inconclusive, reports::Verdict::info}) {
    EXPECT_TRUE(worst(verdict, "pressure_l2").tables.empty());
    EXPECT_TRUE(worst(verdict, "pressure_l2").files.empty());
  }
  EXPECT_TRUE(worst(reports::Verdict::fail, "front_position").tables.empty()) << "a front has no cells";
  EXPECT_TRUE(worst(reports::Verdict::fail, "saturation_l2").tables[0].rows.empty()) << "there it is exact";
}

}  // namespace
}  // namespace wetfront::verification
