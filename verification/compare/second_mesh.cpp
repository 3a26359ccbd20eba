#include "verification/compare/second_mesh.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {

std::vector<Measurement> failure_on_two_meshes(double here, double there, const std::string& cells) {
  if (std::isnan(here) && std::isnan(there)) return {};
  const auto told = [](double time) {
    return std::isnan(time) ? "does not fail" : fmt::format("fails at {:.6g} s", time);
  };
  const double error = std::isnan(here) || std::isnan(there) ? 1 : std::abs(here - there) / here;
  return {{"failure_time_mesh",
           "time of failure against that " + cells,
           -1,
           "",
           error,
           {},
           fmt::format("it {} here, and {} {}", told(here), told(there), cells)}};
}

}  // namespace wetfront::verification
