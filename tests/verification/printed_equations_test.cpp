// The damage done by the seed paper's misprints, as verification/cases/printed_equations/README.md states it.
#include "verification/compare/balance.h"
#include "verification/compare/events.h"
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

RunResult run_case(const std::string& name) {
  return run_prepared(
      prepare(read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/printed_equations" / name)));
}

TEST(PrintedEquations, TheMassBalanceLosesATenthOfTheWindowsRain) {
  const RunResult result = run_case("printed_mass_balance.toml");
  EXPECT_EQ(result.exit, Exit::fail);
  for (const auto& finding : result.record.findings)
    if (finding.quantity == "rain_delivered") {
      EXPECT_EQ(finding.verdict, reports::Verdict::fail);
      EXPECT_NEAR(finding.error, 0.107, 0.005);
    }
}

TEST(PrintedEquations, TheExponentBringsTheWaterFourTimesTooEarly) {
  const RunResult result = run_case("printed_mualem.toml");
  EXPECT_EQ(result.exit, Exit::fail);
  const auto arrival = [](const meshes::FieldHistory& history) {
    for (const auto& gauge : history.gauges)
      if (gauge.name == "base") return crossing_time(gauge, arrival_pressure);
    return 0.0;
  };
  EXPECT_NEAR(arrival(result.candidate.history), 625, 10);
  EXPECT_NEAR(arrival(result.reference->reference.history), 2843, 10);
}

}  // namespace
}  // namespace wetfront::verification
