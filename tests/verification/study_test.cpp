// Studies as a user meets them: points side by side, a killed study resumed without computing finished points again,
// job arrays, and the choice of a setting by a stored study of accuracy.
#include "reports/palette.h"
#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/verification/program.h"
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/study/effects.h"
#include "verification/study/points.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <map>
#include <set>
#include <thread>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;
using test::Output;
using testing::HasSubstr;

const std::string seed = WETFRONT_SOURCE_DIR "/verification/cases/seed_column/scene_3e-5_smin0.87.toml";

class Study : public test::Program {
 protected:
  /// Times at which points were finished, by folder.
  std::map<std::string, fs::file_time_type> finished(const fs::path& study) const {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& entry : fs::directory_iterator(study))
      if (fs::exists(entry.path() / "point.json"))
        times[entry.path().filename()] = fs::last_write_time(entry.path() / "point.json");
    return times;
  }
};

const std::string vary = "study vary " + seed + " --set rain.intensity=2e-5,3e-5,4e-5 --out study --jobs 1";

/// kill -9 after the first point: it stays as it is, the others are computed, and the page has all.
TEST_F(Study, AKilledStudyGoesOnWhereItWas) {
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.c_str()) != 0) _exit(1);
    execl("/bin/sh", "sh", "-c", ("exec " WETFRONT_PROGRAM " " + vary + " > /dev/null 2>&1").c_str(), nullptr);
    _exit(1);
  }
  for (int i = 0; i < 3000 && (!fs::exists(folder / "study") || finished(folder / "study").empty()); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const auto before = finished(folder / "study");
  ASSERT_GE(before.size(), 1u);
  ASSERT_LT(before.size(), 3u);
  const Output output = wetfront(vary);
  EXPECT_THAT(output.text, HasSubstr(std::to_string(before.size()) + " of 3 points are finished"));
  const auto after = finished(folder / "study");
  EXPECT_EQ(after.size(), 3u);
  for (const auto& [name, time] : before) EXPECT_EQ(after.at(name), time) << name << " was computed again";
  EXPECT_TRUE(fs::exists(folder / "study/report.html"));
  ASSERT_EQ(wetfront("report .").code, 0);
  const std::string overview = reports::read_whole(folder / "index.html");
  EXPECT_THAT(overview, HasSubstr("<h2>Studies</h2>")) << "a study is no comparison";
  EXPECT_THAT(overview, HasSubstr(": parametric study</a>"));
  EXPECT_THAT(overview, testing::Not(HasSubstr("<h2>Comparisons</h2>")));
}

TEST_F(Study, JobArraysComputePointsOneByOne) {
  const std::string study = "study vary " + seed + " --set rain.intensity=2e-5,3e-5 --out array ";
  EXPECT_EQ(wetfront(study + "--list").text, "0  rain.intensity=2e-5\n1  rain.intensity=3e-5\n");
  const Output early = wetfront(study + "--point 0");
  EXPECT_THAT(early.text, HasSubstr("point 0  rain.intensity=2e-5: "));
  const Output missing = wetfront(study + "--gather");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.text, HasSubstr("missing: 1"));
  wetfront(study + "--point 1");
  EXPECT_THAT(wetfront(study + "--gather").text, HasSubstr("2 points"));
  EXPECT_THAT(wetfront(study + "--point 2").text, HasSubstr("there is no such point"));
}

TEST_F(Study, PointsLeftOutForTheirCostAreNotMissed) {
  const std::string study = "study accuracy " + seed + " --out costly ";
  const Output gathered = wetfront(study + "--budget 1e-9 --gather");
  EXPECT_EQ(gathered.code, 0) << gathered.text;
  EXPECT_TRUE(fs::exists(folder / "costly/report.html"));
  EXPECT_TRUE(finished(folder / "costly").empty()) << "not even the cheapest may be run";
  EXPECT_THAT(wetfront(study + "--budget 1e9 --gather").text, HasSubstr("missing: 0, 1, "));
}

TEST_F(Study, OptionsThatWouldChangeNothingAreRefused) {
  const auto refused = [&](const std::string& arguments) {
    const Output output = wetfront(arguments);
    EXPECT_EQ(output.code, 2) << arguments << '\n' << output.text;
    EXPECT_TRUE(fs::is_empty(folder)) << arguments << " ran";
    return output.text;
  };
  for (const char* option : {"--jobs 2", "--list", "--point 0", "--gather"})
    refused("study difference " + seed + " " + option);
  refused("run " + seed + " --study out/any");
  refused("run " + seed + " --accuracy 1% --quantity front_position --set rain.intensity=2e-5");
  refused("run " + seed + " --accuracy 1% --study out/any --set rain.intensity=2e-5");
  EXPECT_THAT(refused("run " + seed + " --accuracy 1% --resume"), HasSubstr("keep no checkpoint"));
}

TEST_F(Study, ARefusedPointIsAResultAndSaysWhy) {
  const Output output = wetfront("study vary " + seed + " --set soil.sand.porosity=1.5 --out refused");
  EXPECT_EQ(output.code, 2);
  EXPECT_THAT(output.text, HasSubstr("porosity = 1.5 is out of range"));
  EXPECT_THAT(wetfront("study vary " + seed + " --set rain.intensty=1").text, HasSubstr("Did you mean 'intensity'?"));
}

/// What a slope is studied for: when it fails, how deep, how far, over rain by what the ground takes.
TEST_F(Study, RainOnASlopeTellsOfItsSlide) {
  const Output output = wetfront("study vary " WETFRONT_SOURCE_DIR
                                 "/verification/cases/small_slope/scene.toml "
                                 "--set rain.intensity=2e-4,4e-4 --set geometry.profile.cells_over=2 "
                                 "--set geometry.profile.cells_along=12 --out slope");
  ASSERT_EQ(output.code, 0) << output.text;
  const std::string result = reports::read_whole(folder / "slope/result.json");
  for (const char* said :
       {"time of failure [s]", "depth of what had moved at failure", "largest velocity of a marker [m/s]", ", deep",
        "rain.intensity / k_s", "The type of failure is the same at all of these intensities.", "rain_displacement"})
    EXPECT_THAT(result, HasSubstr(said));
}

TEST(Points, AreEveryCombination) {
  const auto points = product({read_variation("a.b=1,2"), read_variation("c=[1,2],[3,4],")});
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[1].name, "a.b=1, c=[3,4]");
  EXPECT_EQ(points[5].settings[1].value, "") << "an empty value leaves the key out";
  EXPECT_THROW(read_variation("a=1,1"), SceneError);
  EXPECT_THROW(product({read_variation("a=1"), read_variation("a=2")}), SceneError);
}

TEST(Points, AreNamedByWhatTheyCompute) {
  const StudyPoint one{"", {{"rain.intensity", "2e-5"}}}, other{"", {{"rain.intensity", "3e-5"}}};
  EXPECT_EQ(point_hash(seed, one), point_hash(seed, one));
  EXPECT_NE(point_hash(seed, one), point_hash(seed, other));
}

PointResult result(double cpu, double error, double bound) {
  PointResult out;
  out.candidate_cpu = cpu;
  reports::Finding finding;
  finding.quantity = "pressure_l2";
  finding.error = error;
  finding.reference_bound = bound;
  out.findings = {finding};
  return out;
}

TEST(Accuracy, TheCheapestSettingWithinTheTargetIsTaken) {
  const std::vector<PointResult> results = {result(1, 0.02, 0), result(4, 0.005, 0), result(2, 0.009, 0.002),
                                            result(3, 0.012, 0)};
  EXPECT_EQ(cheapest(results, "pressure_l2", 0.01), 1u) << "the reference's own doubt counts: 0.9 % + 0.2 % is more";
  EXPECT_EQ(cheapest(results, "pressure_l2", 0.012), 2u);
  EXPECT_FALSE(cheapest(results, "pressure_l2", 0.001).has_value());
  EXPECT_THAT(pareto(results, "pressure_l2"), testing::ElementsAre(0, 2, 1));
}

/// A quarter of the error at four times the cells is first order, also where the point between them is missing.
TEST(Accuracy, OrdersAreToldByTheCellsThatThereAre) {
  std::vector<AccuracyPoint> points;
  for (const double cells : {1.0, 2.0, 4.0})
    points.push_back({{std::to_string(cells), {{"geometry.column.cells", "1"}}}, "a scheme", cells});
  const double unknown = std::nan("");
  const reports::Record page =
      accuracy_page(read_scene(seed), points, {result(1, 0.04, 0), result(1, unknown, 0), result(1, 0.01, 0)}, {},
                    testing::TempDir());
  const auto orders = std::ranges::find(page.tables, std::string("Orders"), &reports::Table::section);
  ASSERT_NE(orders, page.tables.end());
  ASSERT_EQ(orders->rows.size(), 1u);
  EXPECT_EQ(orders->rows[0][2], "1.00");
}

TEST(Accuracy, ErrorsAreClassedByHowTheyFall) {
  EXPECT_EQ(convergence_of({0.04, 0.01, 0.0025}), Convergence::monotone);
  EXPECT_EQ(convergence_of({0.04, 0.01, 0.012}), Convergence::oscillatory);
  EXPECT_EQ(convergence_of({0.01, 0.005, 0.02}), Convergence::divergent);
  EXPECT_EQ(convergence_of({0.01, 0.01}), Convergence::divergent);
  EXPECT_EQ(convergence_of({0.01}), Convergence::none);
}

/// A window's points have their orders, too; what misses the scene's gates there has run all the same; what did not
/// happen has no error; reference and front have colours that no scheme has.
TEST(Accuracy, WindowsAreToldAsTheWholeSceneIs) {
  std::vector<AccuracyPoint> points;
  std::vector<PointResult> results;
  for (const double cells : {1.0, 2.0, 4.0}) {
    points.push_back({{fmt::format("explicit, {:g} cells, from 1 s for 2 s", cells), {{"a", "1"}}},
                      "explicit",
                      cells,
                      "from 1 s for 2 s"});
    results.push_back(result(cells, 0.04 / (cells * cells), 0));
    results.back().exit = static_cast<int>(Exit::inconclusive);
    reports::Finding late;
    late.quantity = "arrival_time";
    late.error = std::numeric_limits<double>::infinity();
    results.back().findings.push_back(late);
  }
  for (int scheme = 0; scheme < 9; ++scheme) {
    points.push_back({{"s", {}}, "scheme " + std::to_string(scheme)});
    results.push_back(result(1 + scheme, 0.04 / (1 + scheme), 0));
  }
  const reports::Record page =
      accuracy_page(read_scene(seed), points, results, {{320, 0.2, 1e-5}, {160, 0.1, 4e-5}}, testing::TempDir());
  const auto titled = [&](const std::string& title) {
    return *std::ranges::find(page.tables, title, &reports::Table::title);
  };
  const reports::Table orders = titled("Order in the cell size, a window from 1 s for 2 s");
  ASSERT_EQ(orders.rows.size(), 1u);
  EXPECT_EQ(orders.rows[0][2], "2.00, 2.00");
  EXPECT_EQ(orders.rows[0][3], "monotone");
  const reports::Table settings = titled("Settings, a window from 1 s for 2 s");
  EXPECT_THAT(settings.rows[0], testing::ElementsAre("explicit, 1 cells", "-", "1", "4 %", "-", "yes", ""));
  std::map<int, std::set<std::string>> curves;
  for (const reports::Series& series : page.figures[0].series)
    if (!series.label.empty()) curves[series.colour].insert(series.label);
  EXPECT_EQ(curves.at(reports::colour_of_the_reference), std::set<std::string>{"reference, at its nodes"});
  EXPECT_EQ(curves.at(reports::colour_of_the_best), std::set<std::string>{"Pareto front"});
  EXPECT_NE(reports::colour_of(reports::colour_of_the_reference), reports::colour_of(reports::colour_of_the_best));
  for (int scheme = 0; scheme < 9; ++scheme)
    for (const int own : {reports::colour_of_the_reference, reports::colour_of_the_best})
      EXPECT_NE(reports::colour_of(scheme), reports::colour_of(own));
}

/// No reference knows a run-out: runs are told by how far they are off from the one on the finest cells.
TEST(Accuracy, WhatComesOutOfASlideIsHeldAgainstTheFinestCells) {
  std::vector<AccuracyPoint> points;
  std::vector<PointResult> results;
  for (const auto& [cells, moved] : std::vector<std::pair<double, double>>{{1, 2.2}, {4, 2.0}, {2, 2.1}}) {
    points.push_back({{fmt::format("{:g} x", cells), {}}, "dynamics", cells});
    results.push_back(result(cells, std::nan(""), 0));
    results.back().candidate = {{"failure_time", "time of failure", "s", std::nan("")},
                                {"largest_displacement", "largest displacement", "m", moved}};
  }
  EXPECT_FALSE(finest_with(points, results, "failure_time").has_value()) << "it never failed";
  ASSERT_EQ(finest_with(points, results, "largest_displacement"), 1u);
  EXPECT_THAT(
      changes_from(results, 1, "largest_displacement"),
      testing::ElementsAre(testing::DoubleNear(0.1, 1e-12), testing::IsNan(), testing::DoubleNear(0.05, 1e-12)));
  const reports::Record page = accuracy_page(read_scene(seed), points, results, {}, testing::TempDir());
  const auto table = std::ranges::find(page.tables, std::string("What came out of the slide"), &reports::Table::title);
  ASSERT_NE(table, page.tables.end());
  EXPECT_THAT(table->rows[0], testing::ElementsAre("1 x", "1", "2.2 (10 %)"));
  EXPECT_THAT(table->rows[1], testing::ElementsAre("4 x", "4", "2 (finest)"));
  ASSERT_EQ(page.figures.size(), 1u);
  EXPECT_EQ(page.figures[0].id, "work_largest_displacement");
}

/// Values are matched by name: a run that lacks one must not take another's.
TEST(Vary, OutcomesAreMatchedByName) {
  PointResult full = result(1, 0.01, 0), less = full;
  full.candidate = {{"front_position@0", "front", "m", 0.5}, {"stored_water@0", "stored water", "m", 0.25}};
  less.candidate = {{"stored_water@0", "stored water", "m", 0.75}};
  const reports::Record page =
      vary_page(read_scene(seed), {read_variation("rain.intensity=2e-5,3e-5")}, {full, less}, testing::TempDir());
  const auto table = std::ranges::find(page.tables, std::string("Outcomes"), &reports::Table::section);
  ASSERT_NE(table, page.tables.end());
  EXPECT_THAT(table->rows[1], testing::ElementsAre("", "-", "0.75"));
  for (const auto& figure : page.figures)
    EXPECT_THAT(figure.series[0].y, testing::ElementsAre(0.25, 0.75)) << figure.id;
  EXPECT_EQ(page.figures.size(), 1u) << "the front has one value only, which does not vary";
}

TEST(Effects, NeedIsChangeAgainstToleranceAndDoubt) {
  const Scene scene = read_scene(seed);
  const auto with = [](double value) {
    PointResult out;
    out.candidate = {{"stored_water@0", "stored water", "m", value}};
    return out;
  };
  const auto need = [&](double finer, double changed) {
    return overall_need(influences(scene, with(1), with(finer), with(changed)));
  };
  EXPECT_EQ(need(1.001, 1.5), Need::needed);
  EXPECT_EQ(need(1.001, 1.002), Need::not_needed);
  EXPECT_EQ(need(1.02, 1.015), Need::undecided) << "the mesh leaves more open than the change";
  EXPECT_EQ(need(1.02, 1), Need::not_needed);
  EXPECT_EQ(overall_need({}), Need::unknown);
}

/// A run that was refused says nothing of its effect: it is not an event that "happens only with it".
TEST(Effects, ARefusedRunIsNoEvidence) {
  const Scene scene = read_scene(seed);
  PointResult base, refused;
  base.candidate = {{"stored_water@0", "stored water", "m", 1}};
  refused.exit = static_cast<int>(Exit::bad_input);
  EXPECT_TRUE(influences(scene, base, base, refused).empty());
  refused.exit = static_cast<int>(Exit::gave_up);
  EXPECT_TRUE(influences(scene, base, base, refused).empty());
  refused.exit = static_cast<int>(Exit::pass);
  EXPECT_EQ(overall_need(influences(scene, base, base, refused)), Need::needed) << "the outcome no longer happens";
  EXPECT_EQ(overall_need(influences(scene, base, base, refused, 0.25)), Need::undecided) << "coarse cells may miss it";
}

/// An event that is gone and one that is new are not the same thing.
TEST(Effects, ASentenceSaysWhetherAnEventIsGoneOrNew) {
  const Scene scene = read_scene(seed);
  PointResult with, without;
  with.candidate = {{"ponding_time", "time of ponding", "s", 100}};
  without.candidate = {{"ponding_time", "time of ponding", "s", std::nan("")}};
  const EffectChange left_out{"inertia of the water", true, "seepage", {}};
  const auto gone = influences(scene, with, with, without), fresh = influences(scene, without, without, with);
  ASSERT_EQ(gone.size(), 1u);
  ASSERT_EQ(fresh.size(), 1u);
  EXPECT_THAT(effect_sentence(left_out, without, gone), HasSubstr("Without it there is no time of ponding any more."));
  EXPECT_THAT(effect_sentence(left_out, with, fresh),
              HasSubstr("Without it there is a time of ponding, otherwise none."));
}

/// The sentence gives the outcome that makes an effect needed, also where another, on which the mesh leaves more open,
/// changes more; a change is told against a gate of the scene, or with what would be noticed.
TEST(Effects, ASentenceNamesTheOutcomeThatDecides) {
  const Scene scene = read_scene(seed);
  const auto with = [](double pressure, double front, double water) {
    PointResult out;
    out.candidate = {{"pressure", "highest pressure", "Pa", pressure},
                     {"front_position@0", "front", "m", front},
                     {"stored_water@0", "stored water", "m", water}};
    return out;
  };
  const EffectChange left_out{"inertia of the water", true, "seepage", {}};
  const PointResult base = with(1000, 0.5, 1), finer = with(9000, 0.5, 1);
  const auto all = influences(scene, base, finer, with(6000, 0.6, 1));
  EXPECT_EQ(overall_need(all), Need::needed);
  EXPECT_THAT(effect_sentence(left_out, base, all), HasSubstr("Without it front changes from 0.5 to 0.6 m, "));
  EXPECT_THAT(effect_sentence(left_out, base, all), HasSubstr(" times what is tolerated; no other outcome says so."));
  const auto open = influences(scene, base, finer, with(6000, 0.5, 1));
  EXPECT_THAT(
      effect_sentence(left_out, base, open),
      HasSubstr("undecided. Without it highest pressure changes from 1000 to 6000 Pa (100 Pa would be noticed)"
                "; no other outcome says so. Finer cells change it by 8e+03 Pa."));
  const auto none = influences(scene, base, base, with(1000, 0.5, 1.0001));
  EXPECT_THAT(effect_sentence(left_out, base, none),
              HasSubstr("could be left out. Without it stored water changes by 0.0001 m (0.01 m would be noticed)"));
}

/// What an effect's change writes is a scene: no case of the repository is refused with it.
TEST(Effects, EveryChangeOfEveryCaseIsAScene) {
  std::size_t tried = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(WETFRONT_SOURCE_DIR "/verification/cases")) {
    if (file.path().extension() != ".toml") continue;
    const std::string path = file.path().string();
    std::vector<EffectChange> changes;
    try {
      changes = effect_changes(read_scene(path));
    } catch (const SceneError&) {
      continue;  // a mesh of the user's own, or what is no scene
    }
    for (const EffectChange& change : changes) {
      if (!change.by_nature.empty()) continue;
      EXPECT_NO_THROW(read_scene(path, change.point.settings)) << path << ": " << change.point.name;
      ++tried;
    }
  }
  EXPECT_GT(tried, 200u);
}

/// What follows a skeleton that deforms goes with it.
TEST(Effects, ARigidSkeletonHasNoRidersAndNoPictures) {
  const std::string path = WETFRONT_SOURCE_DIR "/verification/cases/deforming_column/scene.toml";
  std::vector<Setting> settings{{"rider[+]", "{ name = \"D-1\", at = [\"0.01 m\", \"0.5 m\"] }"},
                                {"rider[+]", "{ name = \"D-2\", at = [\"0.01 m\", \"0.8 m\"] }"},
                                {"skeleton.locking", "b-bar"},
                                {"stage[0].picture_every", "100 s"}};
  const Scene scene = read_scene(path, settings);
  ASSERT_EQ(scene.riders.size(), 2u);
  const auto changes = effect_changes(scene);
  const auto rigid = std::ranges::find(changes, "deformation of the skeleton", &EffectChange::effect);
  ASSERT_NE(rigid, changes.end());
  settings.insert(settings.end(), rigid->point.settings.begin(), rigid->point.settings.end());
  EXPECT_TRUE(read_scene(path, settings).riders.empty());
}

/// Contact is tried where a scene has it; what cannot be taken apart is said with its reason.
TEST(Effects, ContactIsTriedAndTheInseparableNamed) {
  const std::string path = WETFRONT_SOURCE_DIR "/verification/cases/moriwaki_flume/contact.toml";
  const Scene flume = read_scene(path), column = read_scene(seed);
  std::vector<std::string> effects;
  for (const EffectChange& change : effect_changes(flume)) {
    effects.push_back(change.effect);
    if (change.by_nature.empty()) {
      EXPECT_NO_THROW(read_scene(path, change.point.settings)) << change.point.name;
    }
  }
  EXPECT_THAT(effects, testing::IsSupersetOf({"friction of the contact", "slip on the contact", "anisotropy"}));
  for (const EffectChange& change : effect_changes(column)) EXPECT_NE(change.effect, "anisotropy") << "one way to go";
  const auto said = [](const Scene& scene) {
    std::vector<std::string> names;
    for (const InseparableEffect& one : inseparable_effects(scene)) names.push_back(one.effect);
    return names;
  };
  EXPECT_THAT(said(flume), testing::ElementsAre("porosity change", "finite rotation"));
  EXPECT_THAT(said(column), testing::ElementsAre("porosity change", "finite rotation", "contact friction"));
}

/// Every change is a scene that can be read: the settings lead somewhere and the reader has no complaint.
TEST(Effects, EightOrMoreAreTriedOnColumnsAndSlopes) {
  for (const char* name : {"seed_column/scene_7.5e-5", "deforming_column/seepage", "small_slope/scene"}) {
    const std::string path = std::string(WETFRONT_SOURCE_DIR "/verification/cases/") + name + ".toml";
    const auto changes = effect_changes(read_scene(path));
    EXPECT_GE(changes.size(), 8u + 2u) << name;
    for (const EffectChange& change : changes) {
      if (!change.by_nature.empty()) continue;  // a rigid skeleton has no failure: refused, and needed all the same
      EXPECT_NO_THROW(read_scene(path, change.point.settings)) << change.point.name;
    }
  }
}

/// What is too dear for the scene's cells is tried on larger ones, against the scene on the same.
TEST(Effects, DearOnesAreTriedOnLargerCells) {
  const Scene scene = read_scene(WETFRONT_SOURCE_DIR "/verification/cases/seed_column/scene_7.5e-5.toml");
  const auto all = effect_changes(scene), changes = affordable(scene, all, 20);
  ASSERT_GT(changes.size(), all.size());
  const EffectChange& drag = changes[3];
  EXPECT_EQ(drag.effect, "water and skeleton with velocities of their own");
  EXPECT_EQ(drag.cells, 0.25);
  ASSERT_LT(drag.base, changes.size());
  EXPECT_TRUE(changes[drag.base].how.empty());
  EXPECT_EQ(changes[drag.base].cells, 0.25);
  EXPECT_EQ(changes[2].base, 0u) << "what is cheap is tried on the scene's own cells";
}

TEST(Accuracy, DearSchemesAreTriedInAWindow) {
  const std::string path = WETFRONT_SOURCE_DIR "/verification/cases/seed_column/scene_7.5e-5.toml";
  const Scene scene = read_scene(path);
  const auto points = window_points(scene, 20);
  std::map<std::string, std::map<std::string, int>> settings_of;  // window, scheme
  for (const AccuracyPoint& one : points) {
    ++settings_of[one.window][one.curve];
    const Scene in_window = read_scene(path, one.point.settings);  // no complaint
    ASSERT_EQ(in_window.stages.size(), 2u);
    const Timeline times = timeline(in_window);
    EXPECT_EQ(times.comparison_times.size(), 1u);
    EXPECT_EQ(times.comparison_times.back(), times.stage_end.back());
    if (one.cells == 4 && (one.curve == "implicit-drag" || one.curve == "explicit")) {  // the dearest of its window
      EXPECT_LE(expected_cpu(path, one.point), 20) << one.point.name;
    }
  }
  ASSERT_EQ(settings_of.size(), 2u) << "of implicit and of explicit drag";
  for (const auto& [window, schemes] : settings_of) {
    EXPECT_GE(schemes.size(), 5u) << window;  // four schemes, softened water
    for (const auto& [scheme, count] : schemes)
      EXPECT_EQ(count, scheme.starts_with("softened water") ? 2 : 5) << window << ' ' << scheme;
  }
  EXPECT_TRUE(window_points(scene, 1e9).empty()) << "nothing is too dear";
}

/// What a stored study is for: two accuracies, two settings, both reached when they are run.
TEST_F(Study, AccuraciesChooseTheirSettings) {
  const std::string scene = WETFRONT_SOURCE_DIR "/verification/cases/seed_column/scene_7.5e-5.toml";
  for (const char* point : {"1", "2", "3", "4"})  // 20 to 160 cells: a run takes what is there of a study
    wetfront("study accuracy " + scene + " --out acc --point " + point);
  std::map<double, std::string> chosen;
  for (const double accuracy : {0.01, 0.001}) {
    const std::string out = "run_" + std::to_string(accuracy);
    const Output run =
        wetfront("run " + scene + " --accuracy " + std::to_string(accuracy) + " --study acc --out " + out);
    EXPECT_THAT(run.text, HasSubstr("the cheapest that reaches it is '"));
    chosen[accuracy] = reports::read_result(folder / out / "result.json").scene_text;
    double worst = 0;
    for (const auto& finding : reports::read_result(folder / out / "result.json").findings)
      if (finding.quantity == "pressure_l2") worst = std::max(worst, finding.error + finding.reference_bound);
    EXPECT_GT(worst, 0);
    EXPECT_LE(worst, accuracy);
  }
  EXPECT_NE(chosen[0.01], chosen[0.001]);
}

/// A stored study without a setting that is fine enough is no obstacle: the MPM is refined as if there were none.
TEST_F(Study, AnAccuracyBeyondTheStudyIsReachedByRefinement) {
  wetfront("study accuracy " + seed + " --out acc --point 0");  // ten cells
  const Output run = wetfront("run " + seed + " --accuracy 0.001 --study acc --out fine");
  EXPECT_TRUE(run.code == 0 || run.code == 4) << run.text;
  EXPECT_THAT(run.text, HasSubstr("none of the 1 settings studied in acc reaches it"));
  const reports::Record record = reports::read_result(folder / "fine/result.json");
  EXPECT_THAT(record.log, testing::Contains(HasSubstr("so the MPM is refined until its own estimated error does")));
  EXPECT_TRUE(std::ranges::any_of(record.tables, [](const auto& table) {
    return table.title.find("ccuracy") != std::string::npos;
  })) << "the runs that looked for it";
  const Output other = wetfront("run " + seed + " --accuracy 1e-9 --quantity front_position --study acc --out never");
  EXPECT_EQ(other.code, 2) << "refinement knows pressure alone";
}

/// From the command to the citation: ten cells of the seed column, each effect in a sentence; `explain` has them until
/// the scene is another.
TEST_F(Study, EffectsAreTriedAndCited) {
  std::string text = reports::read_whole(WETFRONT_SOURCE_DIR "/verification/cases/seed_column/scene_7.5e-5.toml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("cells = 40", "cells = 10");
  replace("cells = 320", "cells = 40");
  reports::write_whole(folder / "column.toml", text);
  const Output study = wetfront("study effects column.toml --budget 1 --jobs 1");
  ASSERT_EQ(study.code, 0) << study.text;
  const reports::Record record = reports::read_result(folder / "out/study_effects_column/result.json");
  const auto table = std::ranges::find(record.tables, std::string("Effects"), &reports::Table::title);
  ASSERT_NE(table, record.tables.end());
  const auto tried = std::ranges::count_if(table->rows, [](const auto& row) { return row[2] != "not separable"; });
  EXPECT_GE(tried, 8);
  const Output cited = wetfront("explain column.toml");
  EXPECT_THAT(cited.text, HasSubstr("what the scene needs, by the study of effects in out/study_effects_column"));
  for (const auto& row : table->rows) {
    EXPECT_THAT(row.back(), testing::MatchesRegex("[A-Z].*[.].*")) << "a sentence on " << row[0];
    EXPECT_THAT(cited.text, HasSubstr(row.back()));
    EXPECT_THAT(study.text, HasSubstr(row.back()));
  }
  for (const auto& one : record.tables)
    for (const auto& row : one.rows) EXPECT_THAT(row, testing::Not(testing::Contains(HasSubstr("nan")))) << one.title;
  reports::write_whole(folder / "column.toml", text + "\n# another scene now\n");
  EXPECT_THAT(wetfront("explain column.toml").text, testing::Not(HasSubstr("what the scene needs")));
}

TEST_F(Study, DifferencesAreExplained) {
  const Output output = wetfront("study difference " + seed + " --out why");
  EXPECT_THAT(output.text, HasSubstr("Where the differences come from"));
  EXPECT_THAT(output.text, HasSubstr("boundary flux"));
  const reports::Record record = reports::read_result(folder / "why/result.json");
  EXPECT_TRUE(std::ranges::any_of(record.findings, [](const auto& one) { return one.group == "Difference ledger"; }));
}

/// Ten cells miss the gates on the fields: where, is listed and written.
TEST_F(Study, AFailingCaseTellsItsWorstPoints) {
  const Output output = wetfront("run " + seed + " --set geometry.column.cells=10 --out coarse");
  EXPECT_EQ(output.code, 1) << output.text;
  EXPECT_TRUE(fs::exists(folder / "coarse/fields/worst_points.pvd"));
  EXPECT_TRUE(fs::exists(folder / "coarse/fields/worst_points_0000.vtu"));
  const reports::Record record = reports::read_result(folder / "coarse/result.json");
  const auto table = std::ranges::find(record.tables, std::string("Worst points"), &reports::Table::section);
  ASSERT_NE(table, record.tables.end());
  EXPECT_EQ(table->rows.size(), 10u);
}

}  // namespace
}  // namespace wetfront::verification
