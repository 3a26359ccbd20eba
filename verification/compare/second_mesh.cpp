#include "verification/compare/second_mesh.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {

std::vector<Measurement> failure_on_two_meshes(double here, double there, const std::string& cells) {
  const bool fails_here = std::isfinite(here), fails_there = std::isfinite(there);
  if (!fails_here && !fails_there) return {};
  const auto told = [](double time) {
    return std::isfinite(time) ? fmt::format("fails at {:.6g} s", time) : "does not fail";
  };
  const double error = fails_here && fails_there ? std::abs(here - there) / here : 1;
  return {{"failure_time_mesh",
           "time of failure against that " + cells,
           -1,
           "",
           error,
           {},
           fmt::format("it {} here, and {} {}", told(here), told(there), cells)}};
}

}  // namespace wetfront::verification
