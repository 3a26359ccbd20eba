#include "meshes/read_msh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

namespace wetfront::meshes {
namespace {

const std::string square_2_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 7 \"the top\"\n2 9 \"soil\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 9 9 9\n$EndNodes\n"
    "$Elements\n2\n1 1 2 7 1 3 4\n2 3 2 9 1 1 2 3 4\n$EndElements\n";

std::filesystem::path write(const std::string& text) {
  // Tests run side by side, each in a process of its own.
  const auto path = std::filesystem::path(testing::TempDir()) / ("wetfront_" + std::to_string(getpid()) + ".msh");
  std::ofstream(path) << text;
  return path;
}

std::string message_of(const std::string& text) {
  try {
    read_msh(write(text));
    return "accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    return message.substr(message.find(".msh:") + 5);
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadMsh, Format22WithNamedSides) {
  const Mesh mesh = read_msh(write(square_2_2));
  EXPECT_EQ(mesh.dim, 2);
  EXPECT_EQ(mesh.node_count(), 4u);  // the node of no cell is left out
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"soil"});
  EXPECT_EQ(mesh.side("the top").faces, (std::vector<int>{2, 3}));
  EXPECT_NO_THROW(validate(mesh));
}

TEST(ReadMsh, MessagesNameThePlaceAndTheRemedy) {
  EXPECT_THAT(message_of(replaced(square_2_2, "2 3 2 9", "2 2 2 9")),
              testing::StartsWith("20:3: elements of gmsh type 2"));
  EXPECT_THAT(message_of(replaced(square_2_2, "1 1 0\n4", "1 one 0\n4")),
              testing::StartsWith("13:5: 'one' is not a finite"));
  EXPECT_THAT(message_of(replaced(square_2_2, "2.2 0", "3.0 0")),
              testing::StartsWith("2:1: format 3.0 cannot be read"));
  EXPECT_THAT(message_of(replaced(square_2_2, "2 9 \"soil\"", "2 8 \"soil\"")),
              testing::HasSubstr("no named physical group"));
  EXPECT_THAT(message_of("hello"), testing::StartsWith("1:1: 'hello' opens no section"));
  EXPECT_THAT(message_of(""), testing::HasSubstr("the mesh has no cells"));
}

TEST(ReadMsh, SurvivesMutilatedFiles) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    std::string text = square_2_2;
    for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(32 + random() % 90);
    if (trial % 3 == 0) text.resize(random() % text.size());
    try {
      validate(read_msh(write(text)));
    } catch (const std::exception&) {  // an error with a message is the right answer; a crash is not
    }
  }
}

}  // namespace
}  // namespace wetfront::meshes
