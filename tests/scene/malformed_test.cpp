/// Every malformed/NN_name.toml against its golden messages in NN_name.txt, word for word.
/// WETFRONT_UPDATE_GOLDEN=1 writes them again: read the difference aloud before committing it.
#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace wetfront::verification {
namespace {

const std::filesystem::path folder = std::filesystem::path(WETFRONT_SOURCE_DIR) / "tests/scene/malformed";

std::vector<std::string> malformed_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Malformed : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { std::filesystem::current_path(folder); }  // messages then carry bare file names
};

TEST_P(Malformed, SaysExactlyThis) {
  std::string said;
  try {
    read_scene(GetParam() + ".toml");
    FAIL() << "the scene was read without complaint";
  } catch (const SceneError& error) {
    for (const std::string& message : error.messages) said += message + "\n";
  }
  const std::string golden = GetParam() + ".txt";
  if (std::getenv("WETFRONT_UPDATE_GOLDEN")) std::ofstream(golden) << said;
  EXPECT_EQ(said, contents(golden));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Malformed, testing::ValuesIn(malformed_scenes()),
                         [](const auto& tested) { return tested.param; });

TEST(MalformedScenes, ThereAreAtLeastTwentyOfThem) {
  EXPECT_GE(malformed_scenes().size(), 20u);
}

std::vector<std::string> complaints_about(const std::string& file) {
  try {
    read_scene(file);
  } catch (const SceneError& error) {
    return error.messages;
  }
  return {};
}

TEST(MalformedScenes, FileThatIsMissing) {
  EXPECT_EQ(complaints_about("no/such.toml"),
            std::vector<std::string>{"no/such.toml:1:1: the scene cannot be read (there is no such file). Check the "
                                     "path, or start one with `wetfront new NAME`."});
}

TEST(MalformedScenes, FolderInPlaceOfAFile) {
  ASSERT_EQ(complaints_about(folder.string()).size(), 1u);
  EXPECT_NE(complaints_about(folder.string())[0].find("this is a folder"), std::string::npos);
}

}  // namespace
}  // namespace wetfront::verification
