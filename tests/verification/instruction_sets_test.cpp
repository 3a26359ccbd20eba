// The kernels are built twice, for every x86-64 machine and for those with AVX2 and FMA; the loader chooses. Which one
// it was must not show in a result: no contraction, and sums in an order that lanes do not change.
#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/verification/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;

using InstructionSets = test::Program;

std::string isa(const fs::path& run) {
  return reports::read_result(run / "result.json").provenance.at("isa");
}

TEST_F(InstructionSets, GiveTheSameBits) {
  const fs::path baseline = fs::path(WETFRONT_PROGRAM).parent_path() / "lib/libwetfront_mpm.so";
  ASSERT_TRUE(fs::exists(baseline));
  const std::string slope =
      "run " WETFRONT_SOURCE_DIR "/verification/cases/small_slope/scene.toml --set comparison.second_mesh=none --out ";
  ASSERT_EQ(wetfront(slope + "own").code, 0);
  setenv("LD_PRELOAD", baseline.c_str(), 1);
  const int code = wetfront(slope + "baseline").code;
  unsetenv("LD_PRELOAD");
  ASSERT_EQ(code, 0);
  EXPECT_EQ(isa(folder / "baseline"), "x86-64");
  if (isa(folder / "own") == "x86-64") GTEST_SKIP() << "this machine has no x86-64-v3";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder / "own/fields")) {
    if (entry.path().extension() != ".vtu") continue;
    const fs::path other = folder / "baseline/fields" / entry.path().filename();
    ASSERT_TRUE(fs::exists(other)) << other;
    EXPECT_TRUE(reports::read_whole(entry.path()) == reports::read_whole(other)) << entry.path().filename();
    ++files;
  }
  EXPECT_GE(files, 10u) << "until failure and through the slide";
}

}  // namespace
}  // namespace wetfront::verification
