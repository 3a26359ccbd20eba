/// Every scene in verification/cases and the template of `wetfront new` read without complaint.
#include "verification/scene/read.h"
#include "verification/scene/scene_template.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace wetfront::verification {
namespace {

const std::filesystem::path cases = std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases";

TEST(Cases, AllRead) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    try {
      const Scene scene = read_scene(entry.path());
      EXPECT_FALSE(scene.requirement.empty()) << entry.path() << ": a case states what it is there to show";
      EXPECT_EQ(scene.text[0], '#') << entry.path() << ": a case opens with the paper and section it stands for";
    } catch (const SceneError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(scenes, 13);
}

TEST(Template, ReadsWhateverItsName) {
  for (const std::string name : {"my slope", "a \"quoted\" \\ name", "", "line\nbreak"}) {
    const auto path =
        std::filesystem::path(testing::TempDir()) / ("wetfront_template_" + std::to_string(getpid()) + ".toml");
    for (const std::string& text : {scene_template(name), slide_template(name)}) {
      std::ofstream(path) << text;
      try {
        const Scene scene = read_scene(path);
        if (name.find("quoted") != std::string::npos) {
          EXPECT_EQ(scene.title, name);
        }
      } catch (const SceneError& error) {
        ADD_FAILURE() << error.what();
      }
    }
    std::filesystem::remove(path);
  }
}

}  // namespace
}  // namespace wetfront::verification
