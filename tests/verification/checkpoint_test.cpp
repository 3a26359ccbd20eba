// Checkpoints are written whole or not at all, verified when read, and the last good one is kept.
#include "verification/run/checkpoint.h"

#include "reports/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <fstream>

namespace wetfront::verification {
namespace {

namespace fs = std::filesystem;

class Checkpoints : public testing::Test {
 protected:
  Checkpoints() {
    fs::create_directories(where.file.parent_path());
    for (const double time : {1.0, 2.0}) {
      mpm::State state;
      state.time = time;
      write_checkpoint(state, where);
    }
  }
  ~Checkpoints() override { fs::remove_all(where.file.parent_path()); }

  /// Time of what is read, -1 for nothing.
  double time_read() {
    note.clear();
    const auto state = read_checkpoint(where, note);
    return state ? state->time : -1;
  }
  void spoil(const fs::path& file, const std::string& content) const {
    std::ofstream(file, std::ios::binary) << content;
  }

  const CheckpointFile where{
      fs::temp_directory_path() / ("wetfront_checkpoint_" + std::to_string(getpid())) / "checkpoint.cbor", "scene A"};
  const fs::path before = where.file.string() + ".before";
  std::string note;
};

TEST_F(Checkpoints, TheNewestIsRead) {
  EXPECT_EQ(time_read(), 2);
  EXPECT_EQ(note, "");
}

TEST_F(Checkpoints, ACutOneIsPassedOver) {
  const std::string whole = reports::read_whole(where.file);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{10}, whole.size() / 2, whole.size() - 1}) {
    spoil(where.file, whole.substr(0, kept));
    EXPECT_EQ(time_read(), 1) << kept << " of " << whole.size();
    EXPECT_THAT(note, testing::HasSubstr("not a whole checkpoint"));
  }
}

TEST_F(Checkpoints, AFlippedBitIsSeen) {
  const std::string whole = reports::read_whole(where.file);
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 4);
    spoil(where.file, flipped);
    EXPECT_EQ(time_read(), 1) << "byte " << i;
  }
}

// Killed between the two renames.
TEST_F(Checkpoints, TheOneBeforeIsEnough) {
  fs::remove(where.file);
  EXPECT_EQ(time_read(), 1);
}

TEST_F(Checkpoints, AnothersIsNotTaken) {
  CheckpointFile other = where;
  other.belongs_to = "scene B";
  EXPECT_FALSE(read_checkpoint(other, note));
  EXPECT_THAT(note, testing::HasSubstr("belongs to another scene or program"));
}

TEST_F(Checkpoints, NothingIsReadWhereBothAreBroken) {
  spoil(where.file, "x");
  spoil(before, "");
  EXPECT_EQ(time_read(), -1);
}

}  // namespace
}  // namespace wetfront::verification
