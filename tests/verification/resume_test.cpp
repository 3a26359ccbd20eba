// A run killed without warning goes on to the same bits, in whichever stage it was hit.
#include "reports/whole_file.h"
#include "tests/verification/program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <vector>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;

const std::string scene = WETFRONT_SOURCE_DIR "/verification/cases/small_slope/scene.toml";

/// The same slope, on which rain goes on after the slide, as in cases/moriwaki_flume/successive_slips.toml.
std::string rained_on_after_its_slide() {
  const std::string next = "[mpm]\n";
  std::string text = reports::read_whole(scene);
  text.insert(text.find(next),
              "[[stage]]\nname = \"rain goes on\"\nscheme = \"seepage\"\nskeleton = \"dynamic\"\n"
              "lasts = \"1 s\"\npicture_every = \"0.25 s\"\n\n");
  const std::string second = "second_mesh = \"coarser\"\n";
  text.erase(text.find(second), second.size());
  return text;
}

class Resume : public test::Program {
 protected:
  /// Fields and figures, by name: everything a run leaves but what it cost.
  std::map<std::string, std::string> left_by(const std::string& run) const {
    std::map<std::string, std::string> files;
    for (const char* part : {"fields", "figures"})
      for (const auto& entry : fs::directory_iterator(folder / run / part))
        files[std::string(part) + "/" + entry.path().filename().string()] = reports::read_whole(entry.path());
    for (const auto& entry : fs::directory_iterator(folder / run))
      if (entry.is_regular_file()) files[entry.path().filename().string()];
    return files;
  }

  /// When each stage ended [s], as the run says.
  std::vector<double> stage_ends(const std::string& run) const {
    const std::string said = reports::read_whole(folder / run / "result.json");
    const std::regex end("\"MPM: stage '[^']*' ends at ([0-9.]+) s");
    std::vector<double> times;
    for (std::sregex_iterator at(said.begin(), said.end(), end), none; at != none; ++at)
      times.push_back(std::stod((*at)[1]));
    return times;
  }

  /// Waits for the first state of that stage ($p: the run): its log begins with the stage's name.
  static std::string until_kept(const std::string& stage) {
    return "while kill -0 $p 2>/dev/null && ! grep -aq \"stage '" + stage +
           "' begins\" killed/checkpoint.cbor 2>/dev/null; do sleep 0.005; done";
  }

  /// The run that nobody kills; when its stages ended [s].
  std::vector<double> run_whole() const {
    std::ofstream(folder / run) << rained_on_after_its_slide();
    const test::Output whole = wetfront("run " + run + " --out whole");
    EXPECT_EQ(whole.code, 0) << whole.text;
    EXPECT_GT(left_by("whole").size(), 10u);
    return stage_ends("whole");
  }

  void expect_the_same(const std::string& when) const {
    const auto expected = left_by("whole"), found = left_by("killed");
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [name, text] : expected) EXPECT_TRUE(found.at(name) == text) << name << ", " << when;
  }

  /// As a run leaves a file that is killed in the middle of writing it, which a kill hits too seldom by itself.
  void leave_half_written(const std::string& run) const {
    fs::create_directories(folder / run / "fields");
    for (const char* file : {"report.html.part4711", "fields/mpm.pvd.part815"})
      std::ofstream(folder / run / file) << "half of i";
  }

  /// NaN where a run did not go on.
  static double resumed_from(const std::string& text) {
    const std::string said = "resume: from t = ";
    const std::size_t at = text.find(said);
    return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + said.size()));
  }

  /// Kills a run once the shell has waited as `wait` says ($p: the run) and goes on with it; the time [s] from which it
  /// went on, NaN where there was nothing to go on from: too early, or it had ended.
  double kill_and_go_on(const std::string& wait) const {
    std::error_code none;
    fs::remove_all(folder / "killed", none);
    const std::string command = "cd " + folder.string() + " && { " WETFRONT_PROGRAM " run " + run +
                                " --checkpoint 0 --out killed >/dev/null 2>&1 & p=$!; " + wait +
                                "; kill -KILL $p 2>/dev/null; }";
    if (std::system(command.c_str()) != 0 || !fs::exists(folder / "killed" / "checkpoint.cbor")) return std::nan("");
    leave_half_written("killed");
    const test::Output on = wetfront("run " + run + " --resume --out killed");
    EXPECT_EQ(on.code, 0) << on.text;
    return resumed_from(on.text);
  }

  const std::string run = "slips.toml";
};

TEST_F(Resume, AKilledRunGoesOnToTheSameBitsInEachStage) {
  const std::vector<double> ends = run_whole();
  ASSERT_EQ(ends.size(), 3u);
  const std::vector<std::string> stages = {"infiltration", "slide", "rain goes on"};
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    bool hit = false;
    for (const char* more : {"0.3", "0.1", "0", "0", "0"}) {
      const double from = kill_and_go_on(until_kept(stages[stage]) + "; sleep " + more);
      if (std::isnan(from)) continue;
      hit = std::ranges::upper_bound(ends, from) - ends.begin() == static_cast<std::ptrdiff_t>(stage);
      expect_the_same("from " + std::to_string(from) + " s");
      if (hit) break;
    }
    EXPECT_TRUE(hit) << "no kill hit the stage '" << stages[stage] << "'";
  }
}

// What only a late kill shows: the rest of a slide is told by the largest energy there was before.
TEST_F(Resume, ARunKilledAgainAndAgainComesToTheSameEnd) {
  const std::vector<double> ends = run_whole();
  ASSERT_EQ(ends.size(), 3u);
  bool late = false, ended = false;
  for (int kills = 0; kills < 100 && !ended; ++kills) {
    // Each life takes at least one step further.
    const std::string command = "cd " + folder.string() + " && touch mark && { " WETFRONT_PROGRAM " run " + run +
                                (kills == 0 ? "" : " --resume") +
                                " --checkpoint 0 --out killed >said 2>&1 & p=$!; while kill -0 $p 2>/dev/null && "
                                "[ ! killed/checkpoint.cbor -nt mark ]; do sleep 0.005; done; sleep 0.25; "
                                "kill -KILL $p 2>/dev/null; }";
    ended = std::system(command.c_str()) != 0;
    const double from = resumed_from(reports::read_whole(folder / "said"));
    late |= from > 0.4 * ends[0] + 0.6 * ends[1] && from < ends[1];
  }
  ASSERT_TRUE(ended) << reports::read_whole(folder / "said");
  EXPECT_TRUE(late) << "no kill hit the end of the slide";
  expect_the_same("after all of them");
}

// Ctrl-C: a checkpoint, the report so far, and no scene after it.
TEST_F(Resume, AnInterruptedRunLeavesItsReportAndGoesOn) {
  const test::Output whole = wetfront("run " + scene + " --checkpoint 0 --out whole");
  ASSERT_EQ(whole.code, 0) << whole.text;
  const std::string name = "stopped/small_slope", dry = WETFRONT_SOURCE_DIR "/verification/cases/dry_column/scene.toml";
  const std::string command = "cd " + folder.string() + " && { " WETFRONT_PROGRAM " run " + scene + " " + dry +
                              " --checkpoint 0 --out stopped >said 2>&1 & p=$!; while [ ! -e " + name +
                              "/checkpoint.cbor ] && kill -0 $p; do sleep 0.005; done; kill -INT $p; wait $p; }";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3);
  const std::string said = reports::read_whole(folder / "said");
  EXPECT_THAT(said, testing::HasSubstr("as asked; --resume goes on from there"));
  EXPECT_THAT(said, testing::HasSubstr("stopped as asked: 1 more not run"));
  EXPECT_TRUE(fs::exists(folder / name / "report.html"));
  EXPECT_FALSE(fs::exists(folder / "stopped/dry_column"));
  const test::Output on = wetfront("run " + scene + " --resume --out " + name);
  EXPECT_EQ(on.code, 0) << on.text;
  EXPECT_FALSE(fs::exists(folder / name / "checkpoint.cbor"));
  EXPECT_EQ(left_by(name), left_by("whole"));
}

// A scheduler ends a point of a job array at its time limit: it is not finished, and goes on when it is asked for
// again.
TEST_F(Resume, APointThatWasStoppedIsNotFinishedAndGoesOn) {
  std::ofstream(folder / run) << rained_on_after_its_slide();
  const std::string point = "study vary " + run + " --set mpm.points_per_cell=4 --out study --point 0";
  ASSERT_EQ(wetfront(point).code, 0);
  const fs::path left = "study" / fs::directory_iterator(folder / "study")->path().filename();
  ASSERT_TRUE(fs::exists(folder / left / "point.json"));
  const auto whole = left_by(left.string());
  bool hit = false;
  for (double after = 0.2; after < 60 && !hit;
       after *= 1.3) {  // until it hits the MPM's run and not what lies around it
    fs::remove_all(folder / "study");
    const std::string command = "cd " + folder.string() + " && { " WETFRONT_PROGRAM " " + point +
                                " >said 2>&1 & p=$!; sleep " + std::to_string(after) +
                                "; kill -TERM $p 2>/dev/null; wait $p; }";
    const int status = std::system(command.c_str());
    hit = fs::exists(folder / left / "checkpoint.cbor");
    if (hit) {
      EXPECT_EQ(WEXITSTATUS(status), 3) << reports::read_whole(folder / "said");
    }
  }
  ASSERT_TRUE(hit);
  EXPECT_FALSE(fs::exists(folder / left / "point.json"));
  EXPECT_NE(wetfront("study vary " + run + " --set mpm.points_per_cell=4 --out study --gather").code, 0);
  const test::Output on = wetfront(point);
  EXPECT_EQ(on.code, 0) << on.text;
  EXPECT_FALSE(std::isnan(resumed_from(on.text))) << on.text;
  EXPECT_EQ(left_by(left.string()), whole);
}

// What belongs to another scene is neither taken nor overwritten.
TEST_F(Resume, AnothersCheckpointIsLeftAlone) {
  fs::create_directories(folder / "out");
  std::ofstream(folder / "out/checkpoint.cbor") << "of something else";
  const test::Output refused = wetfront("run " + scene + " --resume --out out");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.text, testing::HasSubstr("is not a whole checkpoint"));
  EXPECT_EQ(reports::read_whole(folder / "out/checkpoint.cbor"), "of something else");
}

}  // namespace
}  // namespace wetfront::verification
