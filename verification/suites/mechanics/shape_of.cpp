#include "verification/suites/mechanics/shape_of.h"

#include "verification/present/figure_frame.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

namespace wetfront::verification {

reports::Figure shape_of(const Motion<2>& motion, const std::vector<std::size_t>& times) {
  auto figure = figure_frame({"shape", "Material points", "Shape"}, {"x", "m"}, {"y", "m"});
  for (const std::size_t i : times) {
    auto dots = points(fmt::format("{:.3g} s", motion.clouds[i].time));
    for (const auto& x : motion.clouds[i].position) put(dots, x[0], x[1]);
    figure.series.push_back(dots);
  }
  return figure;
}

}  // namespace wetfront::verification
