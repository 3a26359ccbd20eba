// The matrix of hard cases: its quick rows as tests, and that no kind of failure may look like a pass.
#include "verification/suites/hard/hard_suite.h"
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/free_energy.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/hard/hard_entry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace wetfront::verification {
namespace {

using Outcome = HardEntry::Outcome;
using reports::Verdict;

HardCase row(const std::string& name) {
  for (const auto family : {dry_rows, layer_rows, water_rows, rain_rows, surface_rows, carried_rows, invalid_rows})
    for (const HardCase& test : family())
      if (test.name == name) return test;
  throw std::out_of_range(name);
}

/// Runs the row of that name, whose entries all have to hold.
reports::Record row_without_failures(const std::string& name) {
  const reports::Record record = run_case(as_case(row(name)));
  EXPECT_EQ(record.verdict, Verdict::pass);
  for (const auto& finding : record.findings)
    EXPECT_NE(finding.verdict, Verdict::fail) << finding.description << ": " << finding.error;
  return record;
}

/// Rows whose entries all hold, one of each kind; the whole matrix is `wetfront verify hard`.
class HardRow : public ::testing::TestWithParam<const char*> {};

TEST_P(HardRow, HasNoFailedEntry) {
  const reports::Record record = row_without_failures(GetParam());
  const auto entries = std::ranges::find(record.tables, "Entries", &reports::Table::title);
  ASSERT_NE(entries, record.tables.end());
  EXPECT_EQ(entries->rows.size(), std::size(rigid_schemes));
}

INSTANTIATE_TEST_SUITE_P(Quick, HardRow,
                         ::testing::Values("dry_sand_1_mpa", "layers_fine_over_coarse", "k_1e_9", "start_above_zero",
                                           "rain_10_ks", "mesh_border", "invalid_start", "cut_in_mid_ponding",
                                           "thin_cover", "water_incompressible", "closed_box_at_rest",
                                           "closed_box_incompressible", "rain_on_off"),
                         [](const auto& info) { return std::string(info.param); });

/// Of the rows in which a block slides through cells: full of stiff water, of which nodes that the block reaches must
/// be told the pressure (what is not full follows the water that points carry), and two whose surface is inside cells.
class HardCarriedRows : public ::testing::TestWithParam<const char*> {};

TEST_P(HardCarriedRows, HasNoFailedEntry) {
  row_without_failures(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Quick, HardCarriedRows, ::testing::Values("carried_full", "carried_dry", "carried_ponded"),
                         [](const auto& info) { return std::string(info.param); });

/// Films of pieces that share nodes are known only one after the other (seepage_step.cpp, most_leaps): 17 solves fail
/// on the way, and 245 where Newton's method insists on lowering the balance.
TEST(HardCarriedRow, KinksOfASurfaceInsideCellsAreLeaptOver) {
  const HardEntry entry = run_entry(row("carried_ponded"), HardScheme::true_time);
  EXPECT_EQ(entry.outcome, Outcome::ran) << entry.said;
  EXPECT_LT(entry.newton_failures, 100);
}

HardColumn short_column() {
  HardColumn column;
  column.cells = 6;
  column.rain = {{0}, {1e-4}};
  column.outputs = {1, 20};
  return column;
}

HardCase short_row() {
  return column_case({.name = "made_up",
                      .title = "-",
                      .requirement = "-",
                      .source = "-",
                      .column = short_column(),
                      .ends = {20, 1},
                      .cells_off = 1,
                      .reason = "-"});
}

Verdict verdict_of(const HardCase& test) {
  return run_case(as_case(test)).verdict;
}

TEST(HardMatrix, ABoundThatIsMissedFails) {
  HardCase test = short_row();
  EXPECT_EQ(verdict_of(test), Verdict::pass);
  test.judge = [](const auto&, const auto&) { return std::vector<Reading>{{"-", 2, {1, "-", "-"}}}; };
  EXPECT_EQ(verdict_of(test), Verdict::fail);
  test.judge = [](const auto&, const auto&) { return std::vector<Reading>{{"-", std::nan(""), {1, "-", "-"}}}; };
  EXPECT_EQ(verdict_of(test), Verdict::fail);
}

TEST(HardMatrix, SeepageMayRefuseOnlyWhatMakesNoSense) {
  HardCase test = short_row();
  const auto sound = test.problem;
  test.problem = [sound] {
    auto problem = sound();
    problem.soils[0].porosity = 1.5;
    return problem;
  };
  EXPECT_EQ(verdict_of(test), Verdict::fail);
  test.invalid = true;
  EXPECT_EQ(verdict_of(test), Verdict::pass);
  test.problem = sound;  // and a scene that is called invalid must be refused
  EXPECT_EQ(verdict_of(test), Verdict::fail);
}

TEST(HardMatrix, SchemesWithoutALimitMayNotRunOutOfTheirBudget) {
  HardCase test = row("dry_sand_100_kpa");
  test.budget = 1e-3;
  const HardEntry seepage = run_entry(test, HardScheme::bdf2), drag = run_entry(test, HardScheme::explicit_drag);
  EXPECT_EQ(seepage.outcome, Outcome::failed);
  EXPECT_THAT(seepage.said, ::testing::HasSubstr("its budget is 0.001 s"));
  EXPECT_EQ(drag.outcome, Outcome::refused);
  EXPECT_TRUE(drag.too_expensive);
  EXPECT_GT(drag.estimate, 1e-3);
  EXPECT_EQ(verdict_of(test), Verdict::fail);
}

TEST(MisplacedWater, CountsCellsByWhichAFrontLags) {
  const HardColumn column = short_column();
  const auto problem = strip_problem(column);
  meshes::FieldHistory reference, late;
  reference.mesh = late.mesh = problem.mesh;
  // Wet above a cell interface: 4 cells in the one, 3 in the other, of 6 cells of 0.2 m.
  const auto shot = [&](double time, double wet_above) {
    meshes::Snapshot out;
    out.time = time;
    out.cells_hold_averages = true;
    for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c)
      out.cell_pressure.push_back(problem.mesh.cell_centre(c)[1] > wet_above ? 0 : -10e3);
    return out;
  };
  reference.snapshots = {shot(0, 2), shot(20, 0.4)};
  late.snapshots = {shot(0, 2), shot(20, 0.6)};
  const double lag = misplaced_water(column, late, reference);
  // A quarter of the water is missing in a cell 0.4 to 0.6 m above the base: below that the curves agree, above it they
  // differ by a cell's filling over 0.7 m = 3.5 cells, in which the reference holds 4.
  EXPECT_NEAR(lag, 3.5 / 4, 0.02);
  EXPECT_NEAR(misplaced_water(column, reference, reference), 0, 1e-12);
}

TEST(FreeEnergy, SeesWaterThatLiftsItself) {
  HardColumn column = short_column();
  column.rain = {};
  const auto problem = strip_problem(column);
  meshes::FieldHistory history;
  history.mesh = problem.mesh;
  const auto uniform = [&](double time, double top, double base) {
    meshes::Snapshot out;
    out.time = time;
    for (const auto& node : problem.mesh.nodes) out.node_pressure.push_back(base + (top - base) * node[1] / 1.2);
    return out;
  };
  history.ledger = {{0, 0, 0, 0, 0, 0.01, 0.01}, {1, 0, 0, 0, 0, 0.01, 0.01}};
  history.snapshots = {uniform(0, -10e3, -2e3), uniform(1, -2e3, -10e3)};
  EXPECT_NEAR(free_energy_growth(problem, history), 1, 1e-12);
  std::swap(history.snapshots[0].node_pressure, history.snapshots[1].node_pressure);
  EXPECT_EQ(free_energy_growth(problem, history), 0);
  // integral of p dS from 0, against the trapezoidal rule in S.
  double area = 0, before = 1;
  for (double s = 1; s <= 20e3; s += 1) {
    const double now = saturation(problem.soils[0], -s);
    area += (before - now) * (s - 0.5), before = now;
  }
  EXPECT_NEAR(capillary_energy(problem.soils[0], *problem.water, -20e3) / area, 1, 1e-4);
}

TEST(HardSuite, NamesAreFolderNamesAndUsedOnce) {
  std::set<std::string> names;
  for (const Case& test : hard_suite()) {
    EXPECT_EQ(test.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << test.name;
    EXPECT_TRUE(names.insert(test.name).second) << test.name;
    EXPECT_FALSE(test.title.empty() || test.requirement.empty() || test.source.empty()) << test.name;
  }
}

}  // namespace
}  // namespace wetfront::verification
