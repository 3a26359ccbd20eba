#include "meshes/gmsh.h"

#include "meshes/read_msh.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace wetfront::meshes {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "wetfront-mesh-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw std::runtime_error("cannot make a scratch folder in " + fs::temp_directory_path().string() + " (" +
                               std::strerror(errno) + "). Set TMPDIR to a folder that can be written");
    path = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  fs::path path;
};

/// Runs gmsh, its output going to `log`; returns its exit status.
int run_gmsh(const fs::path& script, const fs::path& mesh, int dim, const fs::path& log) {
  const std::string dimension = "-" + std::to_string(dim);
  const char* arguments[] = {"gmsh",     script.c_str(), dimension.c_str(), "-format", "msh41",
                             "-nopopup", "-o",           mesh.c_str(),      nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, "gmsh", &files, nullptr, const_cast<char**>(arguments), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0)
    throw std::runtime_error(std::string("cannot start gmsh (") + std::strerror(failure) +
                             "). Install Debian's package gmsh, or run `make deps`");
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Order of `count` things by elevation, then by the other coordinates, with round-off ignored.
template <class Position>
std::vector<int> order_by_position(std::size_t count, int dim, Position position) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::array<long long, 3>> key(count);
  constexpr double grain = 1e-9;  // m; far below any cell, far above round-off
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = position(i);
    const int up = up_axis(dim);
    key[i] = {std::llround(at[up] / grain), std::llround(at[(up + 1) % 3] / grain),
              std::llround(at[(up + 2) % 3] / grain)};
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key[a] < key[b]; });
  return order;
}

}  // namespace

void renumber_by_position(Mesh& mesh) {
  const auto node_order = order_by_position(mesh.node_count(), mesh.dim, [&](std::size_t i) { return mesh.nodes[i]; });
  std::vector<int> new_index(mesh.node_count());
  std::vector<Point> nodes(mesh.node_count());
  for (std::size_t i = 0; i < node_order.size(); ++i) {
    new_index[node_order[i]] = static_cast<int>(i);
    nodes[i] = mesh.nodes[node_order[i]];
  }
  const auto cell_order =
      order_by_position(mesh.cell_count(), mesh.dim, [&](std::size_t c) { return mesh.cell_centre(c); });
  std::vector<int> cells, region;
  for (int c : cell_order) {
    for (int node : mesh.cell(c)) cells.push_back(new_index[node]);
    region.push_back(mesh.region[c]);
  }
  for (Side& side : mesh.sides)
    for (int& node : side.faces) node = new_index[node];
  mesh.nodes = std::move(nodes);
  mesh.cells = std::move(cells);
  mesh.region = std::move(region);
}

Mesh generate(const std::string& script, int dim) {
  const ScratchFolder scratch;
  const fs::path geo = scratch.path / "shape.geo", msh = scratch.path / "shape.msh", log = scratch.path / "gmsh.log";
  std::ofstream(geo) << script;
  const int status = run_gmsh(geo, msh, dim, log);
  if (status != 0 || !fs::exists(msh))
    throw std::runtime_error("gmsh failed (exit status " + std::to_string(status) + "):\n" + read_text(log));
  Mesh mesh = read_msh(msh);
  renumber_by_position(mesh);
  validate(mesh);
  return mesh;
}

}  // namespace wetfront::meshes
