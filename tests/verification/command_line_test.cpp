// The program as a user meets it: exit codes, messages, files.
#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/verification/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;
using test::Output;
using testing::HasSubstr;

const std::string cases = WETFRONT_SOURCE_DIR "/verification/cases/";

class CommandLine : public test::Program {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
};

TEST_F(CommandLine, RunLeavesReportResultFieldsAndTheScene) {
  const std::string scene = cases + "seed_column/scene_3e-5_smin0.87.toml";
  const Output output = wetfront("run " + scene);
  EXPECT_EQ(output.code, 0) << output.text;
  const fs::path out = folder / "out/scene_3e-5_smin0.87";
  EXPECT_TRUE(fs::exists(out / "report.html"));
  EXPECT_EQ(reports::read_whole(out / "scene.toml"), reports::read_whole(scene));
  EXPECT_THAT(reports::read_whole(out / "result.json"), HasSubstr("\"git_hash\""));
  EXPECT_TRUE(fs::exists(out / "fields/mpm_points.pvd"));
  const Output again = wetfront("report out/scene_3e-5_smin0.87");
  EXPECT_EQ(again.code, 0) << again.text;
}

/// Another code's column, as `make report` judges it: both fields pass, where the rest comes from stays open.
TEST_F(CommandLine, AnotherCodesResultIsJudged) {
  const std::string folder_of = cases + "foreign_infiltration/";
  const Output output = wetfront("compare " + folder_of + "scene.toml " + folder_of + "anura3d.result");
  EXPECT_EQ(output.code, 4) << output.text;
  EXPECT_THAT(output.text, HasSubstr("Anura3D against the reference of foreign_infiltration: INCONCLUSIVE"));
  const auto result = reports::read_result(folder / "out/compare_anura3d/result.json");
  const auto pressure = std::ranges::find(result.findings, std::string("pressure_l2"), &reports::Finding::quantity);
  ASSERT_NE(pressure, result.findings.end());
  EXPECT_EQ(pressure->verdict, reports::Verdict::pass);
  EXPECT_NEAR(pressure->error, 0.0133, 0.0005);
  const auto ledger =
      std::ranges::find(result.tables, std::string("Where the differences come from"), &reports::Table::title);
  ASSERT_NE(ledger, result.tables.end());
  EXPECT_EQ(ledger->rows[0][0], "remainder");
  EXPECT_NEAR(std::stod(ledger->rows[0][1]), 36.4, 2) << "what the case's README says of it";
}

/// Where it costs little a comparison says unasked where its differences come from; else what to call.
TEST_F(CommandLine, CheapComparisonsHaveTheirLedger) {
  const auto ledger_of = [&](const std::string& arguments, const std::string& out) {
    const Output output = wetfront("run " + arguments + " --out " + out);
    EXPECT_TRUE(output.code == 0 || output.code == 4) << output.text;
    std::vector<reports::Table> tables = reports::read_result(folder / out / "result.json").tables;
    std::erase_if(tables, [](const auto& table) { return table.section != "Difference ledger"; });
    return tables;
  };
  const std::string column = cases + "seed_column/scene_3e-5_smin0.87.toml";
  const auto cheap = ledger_of(column, "cheap");
  ASSERT_EQ(cheap.size(), 4u) << "causes, then three quantities";
  EXPECT_EQ(cheap[0].title, "Where the differences come from");
  EXPECT_TRUE(ledger_of(column + " --no-ledger", "without").empty());
  const auto dear = ledger_of(cases + "seed_column/window_3e-5_smin0.87.toml", "dear");
  ASSERT_EQ(dear.size(), 1u);
  EXPECT_THAT(dear[0].caption,
              HasSubstr("wetfront study difference " + cases + "seed_column/window_3e-5_smin0.87.toml"));
}

TEST_F(CommandLine, SeveralScenesShareAnIndex) {
  const Output output = wetfront("run --out both " + cases + "seed_column/scene_3e-5_smin0.87.toml " + cases +
                                 "seed_column/scene_1.5e-4_smin0.87.toml");
  EXPECT_EQ(output.code, 0) << output.text;
  EXPECT_THAT(reports::read_whole(folder / "both/index.html"), HasSubstr("scene_1.5e-4_smin0.87/report.html"));
}

TEST_F(CommandLine, AMissedToleranceExitsWith1) {
  std::string scene = reports::read_whole(cases + "seed_column/scene_3e-5_smin0.87.toml");
  scene += "\n[[tolerance]]\nquantity = \"pressure_linf\"\nvalue = \"0.01 %\"\nreason = \"to be missed\"\n";
  write("missed.toml", scene);
  const Output output = wetfront("run missed.toml");
  EXPECT_EQ(output.code, 1) << output.text;
  EXPECT_THAT(output.text, HasSubstr("FAIL"));
}

/// What the run has left holds its gates, but it is no run.
TEST_F(CommandLine, ARunThatGaveUpIsNoPass) {
  write("stopped.toml", R"(title = "stops when it has used up its time"
[geometry]
column = { height = "1 m", cells = 4000 }
[water]
[[soil]]
name = "sand"
porosity = 0.4
saturated_conductivity = "1 cm/h"
retention = { law = "van-genuchten", alpha = "2 1/m", n = 2, theta_r = 0.05, theta_s = 0.4 }
[initial]
hydrostatic = { water_table = "0 m" }
[[rain]]
side = "top"
intensity = "1 mm/h"
[[stage]]
name = "all"
scheme = "seepage"
until = "10 h"
[mpm]
cpu_budget = "100 ms"
[comparison]
times = ["10 h"]
[[tolerance]]
quantity = "water_balance"
value = "1e-6"
reason = "held as far as it came"
)");
  const Output output = wetfront("run stopped.toml");
  EXPECT_EQ(output.code, 3) << output.text;
  EXPECT_THAT(output.text, HasSubstr("gave up: "));
  EXPECT_THAT(output.text, HasSubstr("stopped: INCONCLUSIVE"));
  EXPECT_THAT(reports::read_whole(folder / "out/stopped/result.json"), HasSubstr("\"verdict\": \"inconclusive\""));
}

TEST_F(CommandLine, RainThatAllRunsOffIsNotComparedByItsRoundOff) {
  ASSERT_EQ(wetfront("new full").code, 0);
  std::string scene = reports::read_whole(folder / "full.toml");
  const auto change = [&scene](const std::string& from, const std::string& to) {
    ASSERT_NE(scene.find(from), std::string::npos) << from;
    scene.replace(scene.find(from), from.size(), to);
  };
  change("water_table = \"0 m\"", "water_table = \"1.2 m\"");  // full to the surface
  change("105 % of filling", "600 s");
  change("\"25 % of filling\", \"50 % of filling\", \"75 % of filling\"", "\"600 s\"");
  scene += "\n[[tolerance]]\nquantity = \"cumulative_infiltration\"\nvalue = \"1 %\"\nreason = \"any\"\n";
  write("full.toml", scene);
  const Output output = wetfront("run full.toml");
  EXPECT_EQ(output.code, 4) << output.text;
  EXPECT_THAT(output.text, HasSubstr("nothing to measure"));
}

TEST_F(CommandLine, BadInputExitsWith2AndRunsNothing) {
  write("typo.toml", "title = \"x\"\n[geometri]\n");
  const Output output = wetfront("run " + cases + "seed_column/scene_3e-5.toml typo.toml");
  EXPECT_EQ(output.code, 2);
  EXPECT_THAT(output.text, HasSubstr("typo.toml:2:"));
  EXPECT_THAT(output.text, HasSubstr("geometry"));
  EXPECT_FALSE(fs::exists(folder / "out"));
  EXPECT_EQ(wetfront("run nowhere.toml").code, 2);
  EXPECT_EQ(wetfront("fly").code, 2);
}

TEST_F(CommandLine, AFolderThatCannotBeWrittenIsSaidBeforeTheRun) {
  write("in_the_way", "");
  std::string scene = reports::read_whole(cases + "seed_column/scene_3e-5.toml");
  scene.replace(scene.find("cells = 320"), 11, "cells = 100000");  // hours, were it run first
  write("long.toml", scene);
  const Output output = wetfront("run long.toml --out in_the_way");
  EXPECT_EQ(output.code, 2) << output.text;
  EXPECT_THAT(output.text, HasSubstr("in_the_way: cannot make the folder"));
}

TEST_F(CommandLine, ScenesOfOneNameDoNotOverwriteEachOther) {
  const Output output = wetfront("run " + cases + "dry_column/scene.toml " + cases + "../cases/dry_column/scene.toml");
  EXPECT_EQ(output.code, 2);
  EXPECT_THAT(output.text, HasSubstr("would both write to"));
}

TEST_F(CommandLine, ANewSceneChecksAndExplains) {
  EXPECT_EQ(wetfront("new my_slope").code, 0);
  const Output check = wetfront("check my_slope.toml");
  EXPECT_EQ(check.code, 0) << check.text;
  const Output explain = wetfront("explain my_slope.toml");
  EXPECT_EQ(explain.code, 0) << explain.text;
  EXPECT_THAT(explain.text, HasSubstr("bytes per point"));
  EXPECT_THAT(explain.text, HasSubstr("my_slope.toml:"));
  EXPECT_EQ(wetfront("new my_slope").code, 2);  // never overwritten
}

/// The scene that a user's own slope begins from slides and comes to rest as it is; here on large cells.
TEST_F(CommandLine, ANewSlopeSlides) {
  EXPECT_EQ(wetfront("new hill --slide").code, 0);
  const Output run = wetfront(
      "run hill.toml --set geometry.profile.cells_along=24 --set geometry.profile.cells_over=3 "
      "--set reference.cells=3 --set tolerance[pressure_l2].value=\"30 %\" --set comparison.second_mesh=none");
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, HasSubstr("PASS          events (failure, rest) that did not come in their time: 0 %"));
}

TEST_F(CommandLine, ReferenceReportsItsOwnError) {
  const Output output = wetfront("reference " + cases + "seed_column/scene_3e-5_smin0.87.toml");
  EXPECT_EQ(output.code, 0) << output.text;
  EXPECT_THAT(output.text, HasSubstr("relative L2 of pore pressure"));
  EXPECT_TRUE(fs::exists(folder / "out/scene_3e-5_smin0.87_reference/report.html"));
}

TEST_F(CommandLine, VerifyRunsTheChosenCasesOfASuite) {
  const Output output = wetfront("verify reference --only srivastava_yeh_wetting");
  EXPECT_EQ(output.code, 0) << output.text;
  const std::string index = reports::read_whole(folder / "out/verify_reference/index.html");
  for (const char* name : {"srivastava_yeh_wetting_10", "srivastava_yeh_wetting_1", "water_", "DoF"})
    EXPECT_THAT(index, HasSubstr(name));
  EXPECT_THAT(reports::read_whole(folder / "out/verify_reference/srivastava_yeh_wetting_1/result.json"),
              HasSubstr("\"order\""));
  EXPECT_EQ(wetfront("verify moon").code, 2);
  EXPECT_EQ(wetfront("verify reference --only moon").code, 2);
}

TEST_F(CommandLine, ADrySceneRunsWithoutAReference) {
  const Output output = wetfront("run " + cases + "dry_column/scene.toml");
  EXPECT_EQ(output.code, 0) << output.text;
  EXPECT_TRUE(fs::exists(folder / "out/dry_column/report.html"));
}

TEST_F(CommandLine, WhatCameOutStandsBesideThatOfASecondMesh) {
  const std::string coarse = " --set geometry.profile.cells_along=12 --set geometry.profile.cells_over=4";
  ASSERT_EQ(wetfront("run " + cases + "small_slope/scene.toml" + coarse).code, 0);
  const std::string result = reports::read_whole(folder / "out/small_slope/result.json");
  EXPECT_THAT(result, HasSubstr("on twice the cell size"));
  EXPECT_THAT(result, HasSubstr("MPM on twice the cell size: stage 'slide' ends"));
  EXPECT_THAT(result, HasSubstr("\"quantity\":\"failure_time_mesh\""));
  // Fields are painted, and the points for ParaView go on to the end of the slide.
  for (const char* picture : {"pressure_field", "saturation_field", "displacement_field"})
    EXPECT_TRUE(fs::exists(folder / "out/small_slope/figures" / (std::string(picture) + ".svg"))) << picture;
  const std::string times = reports::read_whole(folder / "out/small_slope/fields/mpm_points.pvd"), key = "timestep=\"";
  EXPECT_GT(std::stod(times.substr(times.rfind(key) + key.size())), 200);
  const Output none = wetfront("run " + cases + "dry_column/scene.toml --set comparison.second_mesh=coarser");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.text, HasSubstr("nothing comes out of a slide"));
  // 2.2 % where the layer has one cell on the second mesh.
  const std::string gate =
      "small_slope/scene.toml --set geometry.profile.cells_along=12 --set geometry.profile.cells_over=2 --set "
      "'tolerance[+]={ quantity = \"failure_time_mesh\", value = \"2 %\", reason = \"a test\" }'";
  const Output coarser = wetfront("run " + cases + gate);
  EXPECT_EQ(coarser.code, 1) << coarser.text;
  EXPECT_THAT(coarser.text, HasSubstr("FAIL          time of failure against that on twice the cell size"));
  const Output gated = wetfront("run " + cases + gate + " --set comparison.second_mesh=none");
  EXPECT_EQ(gated.code, 2);
  EXPECT_THAT(gated.text, HasSubstr("failure_time_mesh is never evaluated"));
}

TEST_F(CommandLine, ASlopeOfTwoSoilsSlidesUntilItRests) {
  const Output output = wetfront("run " + cases + "layered_slope/scene.toml");
  EXPECT_EQ(output.code, 0) << output.text;
  const std::string result = reports::read_whole(folder / "out/layered_slope/result.json");
  for (const char* part : {"\"water_balance\"", "\"energy_balance\"", "\"momentum_balance\""})
    EXPECT_THAT(result, HasSubstr(part));
}

/// `explain` and `check` take values set anew as `run` does: what is planned is the scene that would be run.
TEST_F(CommandLine, ExplainAndCheckTakeValuesSetAnew) {
  const std::string seed = cases + "seed_column/scene_3e-5.toml";
  EXPECT_THAT(wetfront("explain " + seed + " --set geometry.column.cells=10").text, HasSubstr(" 10 cells"));
  EXPECT_EQ(wetfront("check " + seed + " --set rain.intensity=2e-5").code, 0);
  const Output refused = wetfront("check " + seed + " --set soil.sand.porosity=1.5");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.text, HasSubstr("porosity"));
}

TEST_F(CommandLine, HelpListsTheCommandsAndExitCodes) {
  const Output output = wetfront("--help");
  EXPECT_EQ(output.code, 0);
  for (const char* command : {"run", "explain", "check", "reference", "report", "new", "Exit codes"})
    EXPECT_THAT(output.text, HasSubstr(command));
}

}  // namespace
}  // namespace wetfront::verification
