// The suite of motion: every case that takes less than a second, and what the cases rely on. Needs no reference.
#include "tests/suites/expect_case.h"
#include "verification/suites/mechanics/manufactured_motions.h"
#include "verification/suites/mechanics/mechanics_suite.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"

#include <set>

namespace wetfront::verification {
namespace {

using namespace testing;

TEST_P(SuiteCase, Passes) {
  expect_pass(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Mechanics, SuiteCase, ::testing::ValuesIn(cases_up_to(Effort::quick, mechanics_suite())),
                         case_name);

TEST(MechanicsSuite, NamesAreFolderNamesAndUsedOnce) {
  std::set<std::string> names;
  for (const Case& test : mechanics_suite()) {
    EXPECT_EQ(test.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << test.name;
    EXPECT_TRUE(names.insert(test.name).second) << test.name;
    EXPECT_FALSE(test.title.empty() || test.requirement.empty() || test.source.empty()) << test.name;
  }
}

/// A gate that cannot fail is none: with the stiffness wrong by 2 % the manufactured motion must notice.
TEST(MechanicsFaults, TwoPerCentOfStiffnessIsSeen) {
  const ManufacturedMotion motion = axis_aligned_motion(0.002);
  auto problem = motion.problem(16, {});
  const double right = motion.error(move<2>(problem));
  problem.soils[0].elastic->young *= 1.02;
  EXPECT_GT(motion.error(move<2>(problem)), 1.2 * right) << right;
}

/// Stress first and last are schemes of their own: neither runs as MUSL or as the other. A hundredth of the amplitude is
/// far above round-off and far below what they differ by (.21, .035 and .21 of it).
TEST(MechanicsFaults, StressFirstAndLastAreNotMusl) {
  const ManufacturedMotion motion = axis_aligned_motion();
  const auto run = [&](mpm::StressUpdate update) {
    mpm::SkeletonScheme scheme;
    scheme.locking = mpm::LockingRemedy::none;
    scheme.update = update;
    return move<2>(motion.problem(16, scheme));
  };
  const auto musl = run(mpm::StressUpdate::musl), usf = run(mpm::StressUpdate::usf), usl = run(mpm::StressUpdate::usl);
  EXPECT_EQ(apart(musl, run(mpm::StressUpdate::musl)), 0);
  EXPECT_GT(apart(usf, musl), 0.01 * motion.scale);
  EXPECT_GT(apart(usl, musl), 0.01 * motion.scale);
  EXPECT_GT(apart(usf, usl), 0.01 * motion.scale);
}

TEST(MotionBook, TheProvenanceHasTheThreadsOfTheRun) {
  for (const int threads : {1, 2}) {
    auto problem = dry_problem<2>(rectangle_mesh(1, 1, 4, 4), dry_soil(1000, 1e6, 0.3), {0.001});
    problem.threads = threads;
    const Case moved = motion_case({"made_up", "Made up", "-", "-", Effort::quick, {}},
                                   [&](MotionBook& book) { book.move<2>("a body", problem); });
    EXPECT_EQ(run_case(moved).provenance.at("threads"), std::to_string(threads));
  }
}

/// APIC on eight cells makes a hundredth of the energy: what may be lost does not excuse it.
TEST(MotionBook, EnergyMadeHasAGateOfItsOwn) {
  const auto verdict = [](std::optional<Gate> made) {
    const Case moved = motion_case({"made_up", "Made up", "-", "-", Effort::quick, {}}, [&](MotionBook& book) {
      mpm::SkeletonScheme scheme;
      scheme.transfer = mpm::Transfer::apic;
      scheme.locking = mpm::LockingRemedy::none;
      book.energy = {0.2, "1", "-"};
      book.energy_made = made;
      book.move<2>("axis-aligned", axis_aligned_motion().problem(8, scheme));
    });
    return run_case(moved).verdict;
  };
  EXPECT_EQ(verdict({}), reports::Verdict::fail);
  EXPECT_EQ(verdict(Gate{0.02, "1", "-"}), reports::Verdict::pass);
}

/// The clouds of a run are at the times asked for and hold all of the mass; empty cells stay without points.
TEST(Motion, CloudsAreWhatWasAskedFor) {
  auto problem = dry_problem<2>(rectangle_mesh(1, 1, 4, 4), dry_soil(1000, 1e6, 0.3), {0.01, 0.02});
  fill_only<2>(problem, [](const meshes::Point& at) { return at[0] < 0.5; });
  problem.initial_velocity = [](const std::array<double, 2>&) { return std::array{0.1, 0.0}; };
  const auto motion = move<2>(problem);
  ASSERT_EQ(motion.clouds.size(), 2u);
  EXPECT_EQ(motion.points, 32u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& cloud = motion.clouds[i];
    EXPECT_NEAR(cloud.time, 0.01 * static_cast<double>(i + 1), 1e-15);
    EXPECT_NEAR(cloud.total_mass(), 500, 1e-9);
    EXPECT_NEAR(cloud.mean_velocity(0), 0.1, 1e-14);
    EXPECT_NEAR(cloud.kinetic_energy(), 2.5, 1e-12);
    EXPECT_LT(cloud.highest(0), 0.51);
  }
  const auto stopped = move<2>(problem, [](const Cloud<2>&) { return true; });
  EXPECT_EQ(stopped.clouds.size(), 1u);
}

}  // namespace
}  // namespace wetfront::verification
