#include "verification/translate/former_field.h"

#include "meshes/evaluate.h"
#include "reports/base64.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace wetfront::verification {
namespace {

class VtuFile {
 public:
  explicit VtuFile(const std::filesystem::path& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    text_ = text.str();
    if (text_.find("header_type=\"UInt64\"") == std::string::npos)
      fail("it is no field file as wetfront writes them (VTU 1.0, inline base64)");
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(path_.string() + ":1:1: the field cannot be read (" + why +
                             "). Name a reference_grid_*.vtu from the fields/ of a run, or give the points as CSV");
  }

  /// The array of that name: an 8-byte length, then raw values.
  template <class T>
  std::vector<T> array(const std::string& name) const {
    const auto named = text_.find("Name=\"" + name + '"');
    if (named == std::string::npos) fail("it has no '" + name + "'");
    const auto from = text_.find('>', named), to = text_.find("</DataArray>", named);
    if (from == std::string::npos || to == std::string::npos) fail("'" + name + "' does not end");
    const auto bytes = reports::from_base64_parts(text_.substr(from + 1, to - from - 1));
    std::uint64_t length = 0;
    if (bytes.size() >= sizeof length) std::memcpy(&length, bytes.data(), sizeof length);
    if (bytes.size() != sizeof length + length || length % sizeof(T) != 0) fail("'" + name + "' is cut off");
    std::vector<T> values(length / sizeof(T));
    std::memcpy(values.data(), bytes.data() + sizeof length, length);
    return values;
  }

 private:
  std::filesystem::path path_;
  std::string text_;
};

int nearest_node(const meshes::Mesh& mesh, const meshes::Point& point) {
  double least = std::numeric_limits<double>::infinity();
  int nearest = 0;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    double distance = 0;
    for (int axis = 0; axis < mesh.dim; ++axis)
      distance += (mesh.nodes[i][axis] - point[axis]) * (mesh.nodes[i][axis] - point[axis]);
    if (distance < least) least = distance, nearest = static_cast<int>(i);
  }
  return nearest;
}

}  // namespace

std::vector<double> FormerField::at_nodes(const meshes::Mesh& other) const {
  const meshes::Evaluator evaluate(mesh);
  double left = std::numeric_limits<double>::infinity();
  for (const meshes::Point& node : mesh.nodes) left = std::min(left, node[0]);
  std::vector<double> values;
  for (const meshes::Point& node : other.nodes) {
    meshes::Point point = node;
    if (mesh.dim == 1) point = {node[meshes::up_axis(other.dim)]};
    if (mesh.dim == 2 && other.dim == 1) point = {left, node[0]};
    try {
      values.push_back(evaluate(pressure, point));
    } catch (const std::out_of_range&) {
      values.push_back(pressure[nearest_node(mesh, point)]);
    }
  }
  return values;
}

FormerField read_former_field(const std::filesystem::path& path) {
  const VtuFile file(path);
  FormerField field;
  const auto coordinates = file.array<double>("Points");
  const auto connectivity = file.array<std::int64_t>("connectivity");
  const auto types = file.array<std::uint8_t>("types");
  field.pressure = file.array<double>("pore_pressure [Pa]");
  const int dim = types.empty() ? 0 : types[0] == 3 ? 1 : types[0] == 9 ? 2 : types[0] == 12 ? 3 : 0;
  if (dim == 0) file.fail("it holds points and no cells");
  if (coordinates.size() != 3 * field.pressure.size() ||
      connectivity.size() != types.size() * meshes::nodes_per_cell(dim))
    file.fail("its arrays do not fit each other");
  field.mesh.dim = dim;
  for (std::size_t i = 0; i < field.pressure.size(); ++i)
    field.mesh.nodes.push_back({coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]});
  for (const std::int64_t node : connectivity) {
    if (node < 0 || node >= static_cast<std::int64_t>(field.pressure.size())) file.fail("a cell's node is not there");
    field.mesh.cells.push_back(static_cast<int>(node));
  }
  field.mesh.region.assign(types.size(), 0);
  field.mesh.region_names = {"soil"};
  return field;
}

}  // namespace wetfront::verification
