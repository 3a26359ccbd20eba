/// Random damage to a valid scene: whatever comes out is a Scene or a SceneError, never a crash or another exception.
#include "verification/scene/read.h"
#include "verification/scene/scene_template.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace wetfront::verification {
namespace {

const std::vector<std::string> pieces = {
    "\"",   "[",          "]", "[[",          "]]",  "{",     "}",           "=",
    ",",    "\n",         "-", "nan",         "inf", "1e999", "0",           "-1",
    "\xff", "\xc3\xa9",   "%", " of filling", "kPa", "m2",    "[[soil]]\n",  "[water]\n",
    "true", "1979-05-27", "'", "\"\"\"",      "#",   ".",     "a.b.c = 1\n", "9223372036854775807"};

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string done_to(std::string text) {
    for (int hits = 1 + pick(4); hits > 0; --hits) {
      const std::size_t at = pick(text.size()), length = std::min<std::size_t>(1 + pick(12), text.size() - at);
      switch (pick(5)) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, pieces[pick(pieces.size())]);
          break;
        case 2:
          text.replace(at, length, pieces[pick(pieces.size())]);
          break;
        case 3:
          text.insert(pick(text.size()), text.substr(at, 5 * length));
          break;
        default:
          text[at] = static_cast<char>(pick(256));
      }
    }
    return text;
  }

  std::size_t pick(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

 private:
  std::mt19937 random_;
};

/// Damages a scene `times` times; returns how often it was refused.
int refusals(const std::string& sound, int times) {
  const auto path = std::filesystem::path(testing::TempDir()) / ("wetfront_fuzz_" + std::to_string(getpid()) + ".toml");
  Damage damage(20211);
  int refused = 0;
  for (int i = 0; i < times; ++i) {
    const std::string text = damage.done_to(sound);
    std::ofstream(path, std::ios::binary) << text;
    try {
      read_scene(path);
    } catch (const SceneError& error) {
      ++refused;
      EXPECT_FALSE(error.messages.empty()) << text;
      for (const std::string& message : error.messages)
        EXPECT_EQ(message.rfind(path.string() + ":", 0), 0u) << message << "\n" << text;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << text;
    }
  }
  std::filesystem::remove(path);
  return refused;
}

TEST(Fuzz, DamagedScenesAreReadOrRefused) {
  EXPECT_GT(refusals(scene_template("fuzz"), 3000), 1000);  // the damage is real
  EXPECT_GT(refusals(slide_template("fuzz"), 600), 200);
}

TEST(Fuzz, DamagedScenesOfTheReferenceToo) {
  for (const std::string name : {"reference_rising_lake", "reference_dry_layers", "reference_two_layer_column"}) {
    std::ifstream file(std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases" / name / "scene.toml");
    EXPECT_GT(refusals({std::istreambuf_iterator<char>(file), {}}, 1000), 300) << name;
  }
}

}  // namespace
}  // namespace wetfront::verification
