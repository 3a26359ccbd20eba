#include "reports/thinned.h"

#include <cmath>
#include <set>

namespace wetfront::reports {

namespace {

/// The indices in [begin, end) worth drawing, in order.
std::set<std::size_t> outline(const Series& series, std::size_t begin, std::size_t end) {
  std::set<std::size_t> kept = {begin};
  for (const std::vector<double>* values : {&series.x, &series.y}) {
    std::size_t smallest = end, largest = end;
    for (std::size_t i = begin; i < end; ++i) {
      const double value = (*values)[i];
      if (!std::isfinite(value)) {
        kept.insert(i);
        continue;
      }
      if (smallest == end || value < (*values)[smallest]) smallest = i;
      if (largest == end || value > (*values)[largest]) largest = i;
    }
    if (smallest != end) kept.insert({smallest, largest});
  }
  return kept;
}

}  // namespace

Series thinned(const Series& series) {
  const std::size_t count = series.x.size();
  if (count <= drawn_limit) return series;
  Series drawn{series.label, series.style, {}, {}, series.colour};
  const std::size_t runs = drawn_limit / 5;
  const auto keep = [&](std::size_t i) {
    drawn.x.push_back(series.x[i]);
    drawn.y.push_back(series.y[i]);
  };
  for (std::size_t run = 0; run < runs; ++run)
    for (const std::size_t i : outline(series, run * count / runs, (run + 1) * count / runs)) keep(i);
  keep(count - 1);
  return drawn;
}

Figure thinned(const Figure& figure) {
  Figure drawn = figure;
  for (Series& series : drawn.series) series = thinned(series);
  return drawn;
}

}  // namespace wetfront::reports
