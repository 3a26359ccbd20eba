#include "meshes/block_script.h"

#include <sstream>

namespace wetfront::meshes {
namespace {

std::ostringstream exact_stream() {
  std::ostringstream out;
  out.precision(17);
  return out;
}

/// Collects the numbers of a physical group.
std::string group(const std::string& kind, const std::string& name, const std::vector<int>& members) {
  std::string text = "Physical " + kind + "(\"" + name + "\") = {";
  for (std::size_t i = 0; i < members.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(members[i]);
  return text + "};\n";
}

/// Numbers of gmsh entities on a grid of (i, j, k), from 1, `kind` apart.
struct GridNumbers {
  std::array<int, 3> size;  ///< blocks per direction
  int operator()(int kind, int i, int j, int k) const {
    const int per_kind = (size[0] + 1) * (size[1] + 1) * (size[2] + 1);
    return 1 + kind * per_kind + i + (size[0] + 1) * (j + (size[1] + 1) * k);
  }
};

/// Writes points, edges, faces and volumes of a box in blocks.
class SpaceScript {
 public:
  explicit SpaceScript(const SpaceBlocks& blocks) : blocks_(blocks) {
    for (int axis = 0; axis < 3; ++axis) number_.size[axis] = static_cast<int>(blocks.cells[axis].size());
  }

  std::string text() {
    for_all({0, 0, 0}, [&](int i, int j, int k) {
      out_ << "Point(" << number_(0, i, j, k) << ") = {" << blocks_.plane[0][i] << ", " << blocks_.plane[1][j] << ", "
           << blocks_.plane[2][k] << "};\n";
    });
    for (int axis = 0; axis < 3; ++axis) edges(axis);
    for (int axis = 0; axis < 3; ++axis) faces(axis);
    std::vector<int> volumes;
    for_all({1, 1, 1}, [&](int i, int j, int k) {
      const int volume = number_(0, i, j, k);
      out_ << "Surface Loop(" << volume << ") = {" << number_(0, i, j, k) << ", " << number_(0, i + 1, j, k) << ", "
           << number_(1, i, j, k) << ", " << number_(1, i, j + 1, k) << ", " << number_(2, i, j, k) << ", "
           << number_(2, i, j, k + 1) << "};\nVolume(" << volume << ") = {" << volume << "};\nTransfinite Volume {"
           << volume << "};\n";
      volumes.push_back(volume);
    });
    return out_.str() + group("Volume", "soil", volumes);
  }

 private:
  /// All (i, j, k), fewer by `less` in each direction.
  template <class Visit>
  void for_all(std::array<int, 3> less, Visit visit) const {
    for (int k = 0; k <= number_.size[2] - less[2]; ++k)
      for (int j = 0; j <= number_.size[1] - less[1]; ++j)
        for (int i = 0; i <= number_.size[0] - less[0]; ++i) visit(i, j, k);
  }

  void edges(int axis) {
    std::array<int, 3> step{};
    step[axis] = 1;
    for_all(step, [&](int i, int j, int k) {
      const std::array<int, 3> at{i, j, k};
      out_ << "Line(" << number_(axis, i, j, k) << ") = {" << number_(0, i, j, k) << ", "
           << number_(0, i + step[0], j + step[1], k + step[2]) << "};\nTransfinite Curve {" << number_(axis, i, j, k)
           << "} = " << blocks_.cells[axis][at[axis]] + 1 << ";\n";
    });
  }

  /// Faces across `axis`; those at its ends are sides.
  void faces(int axis) {
    static const char* const names[3][2] = {{"left", "right"}, {"front", "back"}, {"base", "top"}};
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<int, 3> less{1, 1, 1}, du{}, dv{};
    less[axis] = 0;
    du[u] = dv[v] = 1;
    std::vector<int> ends[2];
    for_all(less, [&](int i, int j, int k) {
      const std::array<int, 3> at{i, j, k};
      const int face = number_(axis, i, j, k);
      out_ << "Curve Loop(" << face << ") = {" << number_(u, i, j, k) << ", "
           << number_(v, i + du[0], j + du[1], k + du[2]) << ", -" << number_(u, i + dv[0], j + dv[1], k + dv[2])
           << ", -" << number_(v, i, j, k) << "};\nPlane Surface(" << face << ") = {" << face
           << "};\nTransfinite Surface {" << face << "};\nRecombine Surface {" << face << "};\n";
      if (at[axis] == 0) ends[0].push_back(face);
      if (at[axis] == number_.size[axis]) ends[1].push_back(face);
    });
    for (int end : {0, 1}) out_ << group("Surface", names[axis][end], ends[end]);
  }

  const SpaceBlocks& blocks_;
  GridNumbers number_{};
  std::ostringstream out_ = exact_stream();
};

}  // namespace

std::string blocks_of_line(const std::vector<double>& elevation, const std::vector<int>& cells) {
  auto out = exact_stream();
  std::vector<int> lines;
  const int last = static_cast<int>(elevation.size());
  for (int i = 1; i <= last; ++i) out << "Point(" << i << ") = {" << elevation[i - 1] << ", 0, 0};\n";
  for (int i = 1; i < last; ++i) {
    out << "Line(" << i << ") = {" << i << ", " << i + 1 << "};\nTransfinite Curve {" << i << "} = " << cells[i - 1] + 1
        << ";\n";
    lines.push_back(i);
  }
  out << group("Point", "base", {1}) << group("Point", "top", {last}) << group("Curve", "soil", lines);
  return out.str();
}

std::string blocks_in_plane(const PlaneBlocks& blocks) {
  auto out = exact_stream();
  const int along = static_cast<int>(blocks.cells_along.size()), over = static_cast<int>(blocks.cells_over.size());
  const GridNumbers number{{along, over, 0}};
  for (int j = 0; j <= over; ++j)
    for (int i = 0; i <= along; ++i)
      out << "Point(" << number(0, i, j, 0) << ") = {" << blocks.x[i] << ", " << blocks.line[j][i] << ", 0};\n";
  const auto line = [&](int kind, int i, int j, int cells) {
    out << "Line(" << number(kind, i, j, 0) << ") = {" << number(0, i, j, 0) << ", "
        << number(0, i + (kind == 0), j + (kind == 1), 0) << "};\nTransfinite Curve {" << number(kind, i, j, 0)
        << "} = " << cells + 1 << ";\n";
  };
  std::vector<int> base, top, left, right, soil;
  for (int j = 0; j <= over; ++j)
    for (int i = 0; i < along; ++i) line(0, i, j, blocks.cells_along[i]);
  for (int j = 0; j < over; ++j)
    for (int i = 0; i <= along; ++i) line(1, i, j, blocks.cells_over[j]);
  for (int i = 0; i < along; ++i) base.push_back(number(0, i, 0, 0)), top.push_back(number(0, i, over, 0));
  for (int j = 0; j < over; ++j) left.push_back(number(1, 0, j, 0)), right.push_back(number(1, along, j, 0));
  for (int j = 0; j < over; ++j)
    for (int i = 0; i < along; ++i) {
      const int face = number(0, i, j, 0);
      out << "Curve Loop(" << face << ") = {" << number(0, i, j, 0) << ", " << number(1, i + 1, j, 0) << ", -"
          << number(0, i, j + 1, 0) << ", -" << number(1, i, j, 0) << "};\nPlane Surface(" << face << ") = {" << face
          << "};\nTransfinite Surface {" << face << "};\nRecombine Surface {" << face << "};\n";
      soil.push_back(face);
    }
  out << group("Curve", "base", base) << group("Curve", "right", right) << group("Curve", "top", top)
      << group("Curve", "left", left) << group("Surface", "soil", soil);
  return out.str();
}

std::string blocks_in_space(const SpaceBlocks& blocks) {
  return SpaceScript(blocks).text();
}

}  // namespace wetfront::meshes
