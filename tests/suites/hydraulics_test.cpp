// What the suite of the water relies on: problems that say the same to both solvers, and audits that see faults.
#include "mpm/simulation.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/hydraulics/closed_form_on_points.h"
#include "verification/suites/hydraulics/hydraulics_suite.h"
#include "verification/suites/on_points.h"
#include "verification/suites/point_runs.h"
#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/seed_column.h"
#include "verification/suites/setups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace wetfront::verification {
namespace {

/// The seed paper's Table 1 must come back from heads and conductivity to round-off.
TEST(OnPoints, GivesTheSeedPapersNumbersBack) {
  const mpm::Problem<2> problem = on_points(SeedColumn{3e-5}.problem(40, {0.5}));
  const mpm::Soil& soil = problem.soils.at(0);
  const auto& curve = std::get<mpm::VanGenuchtenRetention>(*soil.retention);
  EXPECT_NEAR(curve.air_entry, 4350, 1e-9);
  EXPECT_NEAR(curve.lambda, 0.61, 1e-15);
  EXPECT_NEAR(curve.s_min, 0.087, 1e-15);
  EXPECT_DOUBLE_EQ(curve.s_max, 1);
  EXPECT_NEAR(soil.intrinsic_permeability, 3e-11, 1e-26);
  EXPECT_NEAR(problem.water->bulk_modulus, 0.2e9, 1e-3);
  EXPECT_FALSE(soil.storage.has_value());
  EXPECT_NEAR(problem.gravity[1], -9.81, 1e-15);
  EXPECT_NEAR(*std::ranges::min_element(problem.initial_pressure), -10e3, 1e-9);
  EXPECT_EQ(problem.initial_pressure.size(), problem.mesh.node_count());
  EXPECT_NO_THROW(meshes::validate(problem.mesh));
  EXPECT_NEAR(problem.mesh.cell_measure(7), 0.03 * 0.03, 1e-15);
}

TEST(OnPoints, KeepsStoragesThatOneModulusCannotGive) {
  auto reference = SeedColumn{3e-5}.problem(10, {0.5});
  name_regions(reference.mesh, {"one", "two"}, [](const meshes::Point& at) { return at[0] > 0.6 ? 1 : 0; });
  reference.soils.push_back(reference.soils[0]);
  reference.soils[1].specific_storage = 1e-4;
  const auto problem = on_points(reference);
  EXPECT_FALSE(problem.soils[0].storage.has_value());
  ASSERT_TRUE(problem.soils[1].storage.has_value());
  EXPECT_DOUBLE_EQ(*problem.soils[1].storage, 1e-4 / 9810);
}

TEST(OnPoints, RefusesWhatTheMpmHasNoTermsFor) {
  auto reference = SeedColumn{3e-5}.problem(10, {0.5});
  reference.source = [](const meshes::Point&, double) { return 0.0; };
  EXPECT_THROW(on_points(reference), std::invalid_argument);
}

TEST(PointRuns, AuditSeesLostWaterAndPondedPressure) {
  const mpm::Problem<2> problem = on_points(SeedColumn{1.5e-4}.problem(10, {0.1}));
  meshes::FieldHistory history = mpm::run(problem);
  const WaterAudit sound = audit(problem, history);
  EXPECT_LE(sound.nodes, 1e-8);
  EXPECT_LE(sound.points, 1e-4);
  EXPECT_EQ(sound.overshoot, 0);
  meshes::FieldHistory faulty = history;
  faulty.ledger.back().stored -= 1e-3 * faulty.ledger.back().rain_asked;
  EXPECT_NEAR(audit(problem, faulty).nodes, 1e-3, 1e-6);
  faulty = history;
  faulty.ledger.back().rain_asked *= 1.07;  // what was asked for but neither fell nor ran off
  EXPECT_NEAR(audit(problem, faulty).nodes, 0.07, 1e-3);
  faulty = history;
  faulty.snapshots.back().node_pressure.back() = 5;  // the surface
  EXPECT_NEAR(audit(problem, faulty).overshoot, 5, 1e-12);
  faulty = history;
  faulty.snapshots.back().node_pressure.front() = 9810 * 1.2 + 7;  // the base, under a full column
  EXPECT_NEAR(audit(problem, faulty).overshoot, 7, 1e-6);
}

/// A gate that cannot fail is none: with the permeability wrong by 1 % the closed form must notice.
TEST(HydraulicsFaults, OnePerCentOfPermeabilityFails) {
  const auto exact = srivastava_yeh_case(10, true, {});
  for (const double factor : {1.0, 1.01}) {
    mpm::Problem<2> problem = on_points(exact.problem(100));
    problem.soils[0].intrinsic_permeability *= factor;
    problem.stages[0].time_tolerance = 1e-7;
    const auto errors = head_errors(mpm::run(problem), exact, true);
    const double worst = *std::ranges::max_element(errors);
    EXPECT_EQ(worst <= 4e-4, factor == 1.0) << worst;
  }
}

TEST(HydraulicsSuite, NamesAreFolderNamesAndUsedOnce) {
  std::set<std::string> names;
  for (const Case& test : hydraulics_suite()) {
    EXPECT_EQ(test.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << test.name;
    EXPECT_TRUE(names.insert(test.name).second) << test.name;
    EXPECT_FALSE(test.title.empty() || test.requirement.empty() || test.source.empty()) << test.name;
  }
}

}  // namespace
}  // namespace wetfront::verification
