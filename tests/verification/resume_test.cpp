// A run killed without warning goes on to the same bits, in whichever stage it was hit.
#include "reports/whole_file.h"
#include "tests/verification/program.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;

const std::string scene = WETFRONT_SOURCE_DIR "/verification/cases/small_slope/scene.toml";

class Resume : public test::Program {
 protected:
  /// Fields and figures, by name: everything a run leaves but what it cost.
  std::map<std::string, std::string> left_by(const std::string& run) const {
    std::map<std::string, std::string> files;
    for (const char* part : {"fields", "figures"})
      for (const auto& entry : fs::directory_iterator(folder / run / part))
        files[part + ("/" + entry.path().filename().string())] = reports::read_whole(entry.path());
    return files;
  }

  /// Kills a run once the shell has waited as `wait` says ($p: the run) and goes on with it; the time [s] from which it
  /// went on, NaN where there was nothing to go on from: too early, or it had ended.
  double kill_and_go_on(const std::string& wait) const {
    std::error_code none;
    fs::remove_all(folder / "killed", none);
    const std::string command = "cd " + folder.string() + " && { " WETFRONT_PROGRAM " run " + scene +
                                " --checkpoint 0 --out killed >/dev/null 2>&1 & p=$!; " + wait +
                                "; kill -KILL $p 2>/dev/null; }";
    if (std::system(command.c_str()) != 0 || !fs::exists(folder / "killed" / "checkpoint.cbor")) return std::nan("");
    const test::Output on = wetfront("run " + scene + " --resume --out killed");
    EXPECT_EQ(on.code, 0) << on.text;
    const std::string said = "resume: from t = ";
    const std::size_t at = on.text.find(said);
    return at == std::string::npos ? std::nan("") : std::stod(on.text.substr(at + said.size()));
  }
};

TEST_F(Resume, AKilledRunGoesOnToTheSameBitsInEachStage) {
  const auto begin = std::chrono::steady_clock::now();
  // As often kept as the runs that are killed: keeping takes most of the time here.
  const test::Output whole = wetfront("run " + scene + " --checkpoint 0 --out whole");
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_EQ(whole.code, 0) << whole.text;
  const auto expected = left_by("whole");
  ASSERT_GT(expected.size(), 10u);
  const double failure = 218;  // s; when the slope fails (a little later), see the scene's page
  // The first checkpoint is of the rain's first step; most of the time goes into the slide.
  std::vector<std::string> in_rain(3, "while [ ! -e killed/checkpoint.cbor ] && kill -0 $p; do sleep 0.005; done"),
      in_slide;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7}) in_slide.push_back("sleep " + std::to_string(share * wall));
  for (const auto& [slides, waits] : {std::pair{false, in_rain}, std::pair{true, in_slide}}) {
    bool hit = false;
    for (std::size_t i = 0; i < waits.size() && !hit; ++i) {
      const double from = kill_and_go_on(waits[i]);
      if (std::isnan(from)) continue;
      hit = (from >= failure) == slides;
      const auto found = left_by("killed");
      ASSERT_EQ(found.size(), expected.size());
      for (const auto& [name, text] : expected)
        EXPECT_TRUE(found.at(name) == text) << name << ", from " << from << " s";
    }
    EXPECT_TRUE(hit) << "no kill hit the " << (slides ? "slide" : "infiltration");
  }
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
