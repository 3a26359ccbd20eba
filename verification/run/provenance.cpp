#include "verification/run/provenance.h"

#include "mpm/isa.h"
#include "verification/run/content_hash.h"
#include "verification/run/version.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>

namespace wetfront::verification {
namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

std::map<std::string, std::string> provenance(const std::string& input, const meshes::Mesh& mesh, int threads) {
  ContentHash text, grid;
  text.add(input);
  grid.add(mesh.nodes);
  grid.add(mesh.cells);
  const std::time_t now = std::time(nullptr);
  return {{"version", version::number},
          {"git_hash", version::git_hash},
          {"dirty", version::git_dirty},
          {"input_hash", text.text()},
          {"mesh_hash", grid.text()},
          {"compiler", version::compiler},
          {"isa", mpm::instruction_set()},
          {"threads", std::to_string(threads)},
          {"cpu", processor()},
          {"date", fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(now))}};
}

std::string threads_of_reference(const meshes::FieldHistory& reference) {
  const auto ranks = reference.counters.find("ranks");
  return ranks == reference.counters.end() ? "1" : fmt::format("1 on each of {:g} ranks", ranks->second);
}

}  // namespace wetfront::verification
