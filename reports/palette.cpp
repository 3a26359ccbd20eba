#include "reports/palette.h"

#include <algorithm>
#include <array>
#include <set>

namespace wetfront::reports {

namespace {

// Blue, vermilion, bluish green, reddish purple, orange, sky blue and a dark grey. Okabe and Ito's yellow is left out:
// too faint on white.
constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#b5548f",
                                                "#d08700", "#56b4e9", "#4d4d4d"};
// gnuplot's SVG points: open circle, square, upward and downward triangle, diamond, cross, plus.
constexpr std::array<int, 7> marks = {6, 4, 8, 10, 12, 2, 1};

constexpr const char *reference_colour = "#000000", *best_colour = "#7f4f24";

std::size_t wrapped(int index, std::size_t size) {
  return static_cast<std::size_t>(index < 0 ? 0 : index) % size;
}

}  // namespace

std::string colour_of(int index) {
  if (index == colour_of_the_reference) return reference_colour;
  if (index == colour_of_the_best) return best_colour;
  return colours[wrapped(index, colours.size())];
}

int mark_of(int index) {
  return marks[wrapped(index, marks.size())];
}

std::vector<int> palette_indices(const Figure& figure) {
  std::set<int> taken;
  for (const Series& series : figure.series)
    if (series.colour >= 0) taken.insert(series.colour);
  std::vector<int> indices;
  int next = 0;
  for (const Series& series : figure.series) {
    if (series.colour >= 0) {
      indices.push_back(series.colour);
      continue;
    }
    while (taken.count(next)) ++next;
    indices.push_back(next++);
  }
  return indices;
}

}  // namespace wetfront::reports
