#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <regex>

namespace wetfront::reports {
namespace {

using ::testing::HasSubstr;

/// Exit code of `xmllint --noout FILE`: an independent judge of well-formedness (package libxml2-utils).
int xmllint(const std::filesystem::path& file) {
  return std::system(("xmllint --noout '" + file.string() + "'").c_str());
}

std::string decode(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

/// The values of the array of that name: the 8-byte length must match what follows.
template <class T>
std::vector<T> array(const std::string& file, const std::string& name) {
  const std::regex pattern("Name=\"" + name + "\"[^>]*format=\"binary\">([^<]*)<");
  std::smatch match;
  if (!std::regex_search(file, match, pattern)) throw std::runtime_error("no array " + name);
  const std::string bytes = decode(match[1]);
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  if (bytes.size() != sizeof length + length) throw std::runtime_error("length of " + name);
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof length, length);
  return values;
}

TEST(FieldFiles, GridsAndPointsReadBack) {
  const TemporaryFolder desk;
  write_fields(testing::sample_fields(), desk.path());
  const auto fields = desk.path() / "fields";
  for (const char* name :
       {"mpm_grid_0000.vtu", "mpm_grid_0001.vtu", "mpm_points_0000.vtu", "mpm_grid.pvd", "mpm_points.pvd"})
    EXPECT_EQ(xmllint(fields / name), 0) << name;

  const std::string grid = read_whole(fields / "mpm_grid_0000.vtu");
  EXPECT_THAT(grid, HasSubstr("NumberOfPoints=\"6\" NumberOfCells=\"2\""));
  EXPECT_THAT(array<double>(grid, "Points"), ::testing::ElementsAreArray(testing::sample_fields()[0].nodes));
  EXPECT_THAT(array<std::int64_t>(grid, "connectivity"), ::testing::ElementsAre(0, 1, 3, 2, 2, 3, 5, 4));
  EXPECT_THAT(array<std::int64_t>(grid, "offsets"), ::testing::ElementsAre(4, 8));
  EXPECT_THAT(array<std::uint8_t>(grid, "types"), ::testing::ElementsAre(9, 9));
  EXPECT_THAT(array<double>(grid, "pore_pressure \\[Pa\\]"), ::testing::ElementsAre(-100, -100, -50, -50, 0, 0));
  EXPECT_EQ(array<double>(grid, "saturation &lt;S&gt; &amp; more \\[-\\]").size(), 2U);

  const std::string points = read_whole(fields / "mpm_points_0000.vtu");
  EXPECT_THAT(array<std::uint8_t>(points, "types"), ::testing::ElementsAre(1, 1, 1));
  EXPECT_EQ(array<double>(points, "displacement \\[m\\]").size(), 9U);

  const std::string collection = read_whole(fields / "mpm_grid.pvd");
  EXPECT_THAT(collection, HasSubstr("timestep=\"886\" part=\"0\" file=\"mpm_grid_0000.vtu\""));
  EXPECT_THAT(collection, HasSubstr("timestep=\"1772\" part=\"0\" file=\"mpm_grid_0001.vtu\""));
}

TEST(FieldFiles, LinesAndHexahedra) {
  FieldFile line;
  line.stem = "line";
  line.dim = 1;
  line.nodes = {0, 0, 0, 0, 1, 0, 0, 2, 0};
  line.cells = {0, 1, 1, 2};
  FieldFile cube;
  cube.stem = "cube";
  cube.dim = 3;
  cube.nodes = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  cube.cells = {0, 1, 2, 3, 4, 5, 6, 7};
  const TemporaryFolder desk;
  write_fields({line, cube}, desk.path());
  EXPECT_THAT(array<std::uint8_t>(read_whole(desk.path() / "fields/line_0000.vtu"), "types"),
              ::testing::ElementsAre(3, 3));
  EXPECT_THAT(array<std::uint8_t>(read_whole(desk.path() / "fields/cube_0000.vtu"), "types"),
              ::testing::ElementsAre(12));
}

std::string message_of(const FieldFile& file) {
  const TemporaryFolder desk;
  try {
    write_fields({file}, desk.path());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(FieldFiles, RefusesWhatDoesNotFit) {
  FieldFile file = testing::sample_fields()[0];
  file.fields[0].values.pop_back();
  EXPECT_THAT(message_of(file), HasSubstr("'mpm_grid' at 886 s: field 'pore_pressure [Pa]' has 5 values, not 6 x 1"));
  file = testing::sample_fields()[0];
  file.cells[3] = 6;
  EXPECT_THAT(message_of(file), HasSubstr("cell node 6 of 6"));
  file.cells.pop_back();
  EXPECT_THAT(message_of(file), HasSubstr("7 cell nodes are no multiple of 4"));
  file = testing::sample_fields()[0];
  file.nodes.pop_back();
  EXPECT_THAT(message_of(file), HasSubstr("3 coordinates"));
}

}  // namespace
}  // namespace wetfront::reports
