#include "tests/reports/sample_pictures.h"

#include "reports/film.h"

#include <algorithm>
#include <cmath>

namespace wetfront::reports::testing {

FieldPicture sample_picture() {
  constexpr int wide = 24, high = 8;
  FieldPicture picture{"pressure_field", "Pore pressure at 1772 s", "Fields", "pore pressure", "kPa", {}, {}, {}, {}};
  picture.panels = {{"MPM", {}, false}, {"reference", {}, false}, {"MPM minus reference", {}, true}};
  for (int j = 0; j <= high; ++j)
    for (int i = 0; i <= wide; ++i) {
      const double x = 0.25 * i, base = 0.3 * (6 - x) / 6, y = base + 0.1 * j;
      picture.x.push_back(x);
      picture.y.push_back(y);
      const double reference = 9.81 * (0.9 - y) * (1 - 0.3 * std::sin(x)), error = 0.02 * std::sin(2 * x) * j;
      picture.panels[0].nodal.push_back(reference + error);
      picture.panels[1].nodal.push_back(reference);
      picture.panels[2].nodal.push_back(error);
    }
  for (int j = 0; j < high; ++j)
    for (int i = 0; i < wide; ++i) {
      const int node = j * (wide + 1) + i;
      picture.cells.insert(picture.cells.end(), {node, node + 1, node + wide + 2, node + wide + 1});
    }
  return picture;
}

Film sample_film(int points, int frames) {
  const int wide = std::max(1, static_cast<int>(std::sqrt(3.0 * points))), high = (points + wide - 1) / wide;
  std::vector<FilmMoment> moments;
  for (int k = 0; k < frames; ++k) {
    const double share = static_cast<double>(k) / std::max(1, frames - 1), slid = 2 * share * share;
    FilmMoment moment{10 * share, k == std::min(3, frames - 2) ? "failure" : k + 1 == frames ? "rest" : "", {}, {}, {}};
    moment.values.resize(2);
    for (int p = 0; p < points; ++p) {
      const double along = 3.0 * (p % wide) / wide, up = 1.0 * (p / wide) / high * (1 - 0.4 * share);
      const double moved = slid * (0.4 + 0.6 * up);
      moment.x.push_back((along + moved) * std::cos(0.5) + up * std::sin(0.5));
      moment.y.push_back(3 - (along + moved) * std::sin(0.5) + up * std::cos(0.5));
      moment.values[0].push_back(moved);
      moment.values[1].push_back(9.81 * (0.6 - up));
    }
    moments.push_back(std::move(moment));
  }
  Film heading;
  heading.id = "slide";
  heading.title = "The slide";
  heading.caption = "Points by their displacement.";
  heading.channels = {{"displacement", "m"}, {"pore pressure", "kPa"}};
  heading.ground = {{"base", Series::Style::line, {0, 6}, {3, 3 - 6 * std::tan(0.5)}, 6}};
  return make_film(heading, std::move(moments));
}

Table sample_matrix() {
  Table table{"The matrix", "Verdicts", "Schemes as columns.", {"case", "seepage", "explicit <&>"}, {}};
  table.rows = {{"dry sand", "stable, within bound: 0.2 / 1 cells", "refused: too expensive: 900 s"},
                {"ponding", "FAIL (bound): 2.3 / 1 cells", "stable, within bound: 0.9 / 1 cells"}};
  table.links = {"../seed_column/report.html", "../flume/report.html"};
  table.marks = {{{}, {"pass", "../seed_column/report.html#quantity-pressure-l2"}, {"refused", ""}},
                 {{}, {"fail", "../flume/report.html"}, {"pass", ""}}};
  return table;
}

}  // namespace wetfront::reports::testing
