// The ledger of differences: each injected fault is named first, and the boundary's share is the truth within 5 %.
// Faults are in the candidate alone: rain x 0.93, rain x 1.02 hidden by coarse steps, conductivity lagged by a step,
// another retention curve, doubled drag, a coarse mesh.
#include "lagging_column.h"
#include "reports/whole_file.h"
#include "verification/compare/outcomes.h"
#include "verification/ledger/difference_ledger.h"
#include "verification/ledger/rerun_scene.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>

namespace wetfront::verification {
namespace {

using Fault = std::function<void(mpm::Problem<2>&)>;
const std::filesystem::path seed =
    std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column/scene_7.5e-5.toml";

std::string told(const DifferenceLedger& ledger) {
  std::string text = "causes:";
  for (const auto& [cause, share] : ledger.causes) text += " " + cause + " " + std::to_string(share);
  for (const QuantityLedger& entry : ledger.quantities) {
    text += "\n" + entry.quantity + " " + std::to_string(1e3 * entry.difference()) + " mm:";
    for (const Share& share : entry.shares)
      text += " " + share.cause + " " + std::to_string(1e3 * share.value) + "+-" +
              std::to_string(1e3 * share.uncertainty) + (share.converged ? "" : "!");
    text += " remainder " + std::to_string(1e3 * entry.remainder) + " " + entry.explanation;
  }
  return text;
}

/// The seed column with its references, solved once.
class Ledger : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new Scene(read_scene(seed));
    timeline_ = new Timeline(timeline(*scene_));
    reference_ = new ReferenceRuns(solve_references(*scene_, *timeline_, {}));
  }
  static void TearDownTestSuite() { delete scene_, delete timeline_, delete reference_; }

  static DifferenceLedger explain(const Scene& scene, const CandidateRunner& runner) {
    const meshes::FieldHistory candidate = runner({}).history;
    DifferenceLedger ledger = difference_ledger({scene, *timeline_, candidate, *reference_, runner, {}});
    std::cout << told(ledger) << std::endl;
    return ledger;
  }
  static DifferenceLedger with_fault(const Fault& fault, const std::vector<Setting>& settings = {}) {
    const Scene scene = read_scene(seed, settings);
    return explain(scene, rerun_scene(scene, *timeline_, fault));
  }

  static Scene* scene_;
  static Timeline* timeline_;
  static ReferenceRuns* reference_;
};
Scene* Ledger::scene_ = nullptr;
Timeline* Ledger::timeline_ = nullptr;
ReferenceRuns* Ledger::reference_ = nullptr;

Fault rain_times(double factor) {
  return [factor](mpm::Problem<2>& problem) {
    for (auto& boundary : problem.water_boundary)
      if (auto* rain = std::get_if<mpm::RainSide>(&boundary))
        for (double& intensity : rain->rain.intensity) intensity *= factor;
  };
}

double share_of(const DifferenceLedger& ledger, const std::string& quantity, const std::string& cause) {
  for (const QuantityLedger& entry : ledger.quantities)
    for (const Share& share : entry.shares)
      if (entry.quantity == quantity && share.cause == cause) return share.value;
  ADD_FAILURE() << quantity << ", " << cause;
  return 0;
}

/// What the reference itself makes of rain that is `factor` times as strong, in water taken and in the front.
struct Truth {
  double front, flux;
};
Truth truth_of(double factor, const Timeline& timeline) {
  Scene scene = read_scene(seed);
  const CandidateRunner runner = rerun_scene(scene, timeline);
  const meshes::FieldHistory cells_of = runner({}).history;
  const auto before = solve_reference(scene, timeline, {}).history;
  for (Rain& rain : scene.rains)
    for (double& intensity : rain.record.intensity) intensity *= factor;
  const auto after = solve_reference(scene, timeline, {}).history;
  const std::size_t t = 1;  // the last time with a front
  const auto flux = [&](const meshes::FieldHistory& history) {
    for (const auto& row : history.ledger)
      if (row.time >= timeline.comparison_times[t] * (1 - 1e-12)) return row.infiltrated;
    return 0.0;
  };
  return {fronts(scene, after, cells_of)[t] - fronts(scene, before, cells_of)[t], flux(after) - flux(before)};
}

TEST_F(Ledger, WithoutAFaultThereIsNothingToExplain) {
  const DifferenceLedger ledger = with_fault({});
  for (const QuantityLedger& entry : ledger.quantities) {
    EXPECT_EQ(entry.verdict, reports::Verdict::pass) << entry.quantity;
    EXPECT_LT(entry.size(), 0.25 * entry.tolerance) << entry.quantity;
    EXPECT_GT(entry.reference_mesh.uncertainty, 0) << entry.quantity;
    EXPECT_DOUBLE_EQ(entry.reference_mesh.uncertainty + entry.reference_steps.uncertainty, entry.reference_bound);
  }
  EXPECT_EQ(ledger.quantities.size(), 3u);
}

TEST_F(Ledger, LessRainIsTheBoundarysShare) {
  const DifferenceLedger ledger = with_fault(rain_times(0.93));
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "boundary flux");
  const Truth truth = truth_of(0.93, *timeline_);
  EXPECT_NEAR(share_of(ledger, "front_position", "boundary flux"), truth.front, 0.05 * std::abs(truth.front));
  EXPECT_NEAR(share_of(ledger, "cumulative_flux", "boundary flux"), truth.flux, 0.05 * std::abs(truth.flux));
  EXPECT_NEAR(share_of(ledger, "stored_water", "boundary flux"), truth.flux, 0.05 * std::abs(truth.flux));
  for (const QuantityLedger& entry : ledger.quantities)
    EXPECT_EQ(entry.verdict, reports::Verdict::pass) << entry.quantity;
}

TEST_F(Ledger, MoreRainHiddenByCoarseStepsIsSeen) {
  const DifferenceLedger ledger =
      with_fault(rain_times(1.02), {{"stage.time_integrator", "backward-euler"}, {"stage.time_tolerance", "3e-4"}});
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "boundary flux");
  EXPECT_EQ(ledger.causes[1].first, "time step");
  EXPECT_EQ(ledger.quantities[0].quantity, "front_position");
  EXPECT_TRUE(ledger.quantities[0].cancels) << "rain moves the front down, coarse steps hold it up";
  const Truth truth = truth_of(1.02, *timeline_);
  EXPECT_NEAR(share_of(ledger, "front_position", "boundary flux"), truth.front, 0.05 * std::abs(truth.front));
  EXPECT_NEAR(share_of(ledger, "cumulative_flux", "boundary flux"), truth.flux, 0.05 * std::abs(truth.flux));
}

TEST_F(Ledger, ALaggedConductivityIsTheTimeSteps) {
  const CandidateRunner runner = [&](const Rerun& rerun) {
    LaggingColumn column{1.2,
                         7.5e-5,
                         timeline_->comparison_times.back(),
                         0.46,
                         3e-11 * 9810 / 1e-3,
                         4350,
                         0.61,
                         0.087,
                         1e4,
                         9810,
                         40 << rerun.finer_cells,
                         15 * std::pow(0.25, rerun.finer_steps),
                         rerun.times.empty() ? timeline_->comparison_times : rerun.times};
    return Solved{column.run(), "", ""};
  };
  const DifferenceLedger ledger = explain(*scene_, runner);
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "time step");
}

TEST_F(Ledger, AnotherRetentionCurveIsNamed) {
  const DifferenceLedger ledger = with_fault([](mpm::Problem<2>& problem) {
    for (auto& soil : problem.soils) std::get<mpm::VanGenuchtenRetention>(*soil.retention).air_entry *= 1.3;
  });
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "retention curve");
}

TEST_F(Ledger, DoubledDragIsAMatterOfConductivity) {
  const DifferenceLedger ledger = with_fault([](mpm::Problem<2>& problem) {
    for (auto& soil : problem.soils) soil.intrinsic_permeability /= 2;
  });
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "conductivity");
}

TEST_F(Ledger, ACoarseMeshIsNamed) {
  const DifferenceLedger ledger = with_fault({}, {{"geometry.column.cells", "10"}});
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "mesh");
}

/// A stored result cannot be run again: its flux and its laws are told, its mesh and its steps are not.
TEST_F(Ledger, AStoredResultIsExplainedAsFarAsItCanBe) {
  Scene scene = read_scene(seed);
  const meshes::FieldHistory stored = rerun_scene(scene, *timeline_, rain_times(0.93))({}).history;
  const DifferenceLedger ledger = difference_ledger({scene, *timeline_, stored, *reference_, {}, {}});
  ASSERT_FALSE(ledger.causes.empty());
  EXPECT_EQ(ledger.causes[0].first, "boundary flux");
  for (const Share& share : ledger.quantities[0].shares)
    EXPECT_EQ(share.probed,
              share.cause != "mesh" && share.cause != "time step" && share.cause != "physics outside Richards")
        << share.cause;
}

/// The run is finished before it is explained: a probe that cannot be run costs its own share and nothing else.
TEST_F(Ledger, AProbeThatIsRefusedLosesNothingButItsShare) {
  const auto runner = rerun_scene(*scene_, *timeline_, rain_times(0.93));
  const meshes::FieldHistory candidate = runner({}).history;
  const CandidateRunner refusing = [&](const Rerun& rerun) -> Solved {
    if (rerun.finer_cells > 0 && rerun.times.empty()) throw mpm::CannotPlan("mesh: no such cells (a test). None.");
    if (rerun.finer_steps > 0 && rerun.times.empty()) throw std::runtime_error("steps: not so short (a test). None.");
    return runner(rerun);
  };
  const DifferenceLedger ledger =
      difference_ledger({*scene_, *timeline_, candidate, *reference_, refusing, ReferenceStore()});
  ASSERT_EQ(ledger.quantities.size(), 3u);
  for (const Share& share : ledger.quantities[0].shares)
    EXPECT_EQ(share.probed, share.cause != "mesh" && share.cause != "time step") << share.cause;
  EXPECT_EQ(ledger.causes[0].first, "boundary flux");
  EXPECT_THAT(ledger.log, testing::Contains(testing::HasSubstr("no such cells")));
  EXPECT_THAT(ledger.log, testing::Contains(testing::HasSubstr("not so short")));
}

/// Probes of the reference are kept and taken as the reference itself is.
TEST_F(Ledger, ProbesOfTheReferenceAreTakenFromItsStore) {
  const meshes::FieldHistory stored = rerun_scene(*scene_, *timeline_, rain_times(0.93))({}).history;
  const reports::TemporaryFolder folder;
  const auto explained = [&] {
    return difference_ledger({*scene_, *timeline_, stored, *reference_, {}, {folder.path() / "store"}});
  };
  const DifferenceLedger first = explained(), second = explained();
  EXPECT_THAT(first.log, testing::Not(testing::Contains(testing::HasSubstr("taken from"))));
  EXPECT_THAT(second.log, testing::Contains(testing::HasSubstr("taken from")));
  for (const char* quantity : {"front_position", "stored_water", "cumulative_flux"})
    EXPECT_EQ(share_of(first, quantity, "boundary flux"), share_of(second, quantity, "boundary flux")) << quantity;
}

/// The same of the reference's probes: here none can be kept, as a file is where their folder should be.
TEST_F(Ledger, AProbeOfTheReferenceThatThrowsLosesNothingButItsShare) {
  const meshes::FieldHistory stored = rerun_scene(*scene_, *timeline_, rain_times(0.93))({}).history;
  const reports::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "no folder";
  const DifferenceLedger ledger =
      difference_ledger({*scene_, *timeline_, stored, *reference_, {}, {folder.path() / "file" / "store"}});
  ASSERT_EQ(ledger.quantities.size(), 3u);
  EXPECT_THAT(ledger.quantities[0].shares,
              testing::Contains(testing::AllOf(testing::Field(&Share::cause, "boundary flux"),
                                               testing::Field(&Share::probed, false))));
  EXPECT_THAT(ledger.log, testing::Contains(testing::HasSubstr("cannot be run")));
  for (const QuantityLedger& entry : ledger.quantities) EXPECT_NE(entry.verdict, reports::Verdict::pass);
}

}  // namespace
}  // namespace wetfront::verification
