#include "meshes/evaluate.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;
constexpr double width = 5, height = 3, dry = -500;

bool is_sand(const meshes::Point& at) {
  return at[1] < 1 || (at[1] > 2 && at[0] > 1 && at[0] < 4);
}

/// `along` cells in x, 3/5 as many in y.
fem::RichardsProblem kirkland(int along) {
  fem::RichardsProblem problem;
  problem.mesh = rectangle_mesh(width, height, along, along * 3 / 5);
  name_regions(problem.mesh, {"sand", "clay loam"}, [](const meshes::Point& at) { return is_sand(at) ? 0 : 1; });
  split_side(problem.mesh, "top", "irrigated", [](const meshes::Point& at) { return at[0] > 1 && at[0] < 4; });
  problem.gravity_direction = {0, -1, 0};
  problem.soils = {van_genuchten_soil({0.0286, 0.3658, 2.80, 2.239, 6.26e-5}),
                   van_genuchten_soil({0.106, 0.4686, 1.04, 1.3954, 1.52e-6})};
  problem.boundary = {fem::FluxSide{"irrigated", {{0}, {50 * cm_per_day}}}};
  problem.initial_head.assign(problem.mesh.node_count(), dry);
  problem.end_time = day;
  problem.output_times = {day};
  problem.tolerance = 1e-3;  // the gate is on places, to 0.1 m; the mesh decides them
  return problem;
}

/// Places where the head passes `level` on the lines of nodes of `grid`, along both axes. The heads between the nodes
/// of a run are the finite elements' own, so that contours of two meshes are sampled alike.
std::vector<meshes::Point> contour(const meshes::FieldHistory& history, const meshes::Mesh& grid, double level) {
  const meshes::Evaluator head_at(history.mesh);
  const auto heads = heads_of(history.snapshots.back());
  std::vector<std::pair<meshes::Point, double>> nodes;
  for (const auto& node : grid.nodes) nodes.push_back({node, head_at(heads, node)});
  std::vector<meshes::Point> found;
  for (const int along : {0, 1}) {
    const int across = 1 - along;
    std::sort(nodes.begin(), nodes.end(), [&](const auto& a, const auto& b) {
      return std::pair(a.first[across], a.first[along]) < std::pair(b.first[across], b.first[along]);
    });
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const auto& [low, below] = nodes[i - 1];
      const auto& [high, above] = nodes[i];
      if (low[across] != high[across] || (below > level) == (above > level)) continue;
      meshes::Point at = low;
      at[along] += (level - below) / (above - below) * (high[along] - low[along]);
      found.push_back(at);
    }
  }
  return found;
}

/// Largest distance from a point of `a` to the nearest of `b` [m].
double one_way(const std::vector<meshes::Point>& a, const std::vector<meshes::Point>& b) {
  double worst = 0;
  for (const auto& p : a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& q : b) nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1]));
    worst = std::max(worst, nearest);
  }
  return worst;
}

reports::Figure contours(const std::vector<std::pair<std::string, meshes::FieldHistory>>& runs) {
  reports::Figure figure =
      figure_frame({"contours", "Contours of the head after 1 d", "Fields"}, {"x", "m"}, {"z", "m"});
  int colour = 0;
  for (const auto& [label, history] : runs)
    for (const double level : {0.0, -400.0}) {
      reports::Series series = points(fmt::format("{} m, {}", level, label), colour++);
      for (const auto& at : contour(history, runs.back().second.mesh, level)) put(series, at[0], at[1]);
      figure.series.push_back(series);
    }
  return figure;
}

void judge_run(CaseBook& book, const meshes::FieldHistory& history) {
  const auto heads = heads_of(history.snapshots.back());
  book.judge("water_balance", "water balance at tolerance 1e-3", relative_imbalance(history),
             {1e-6, "1", "gate R9: 1e-6"});
  book.expect("infiltration", "water taken up [m2]", history.ledger.back().infiltrated, 3 * 0.5,
              {1e-6, "1", "50 cm over 3 m, none of which may pond: the sand takes 5.4 m/d"});
  book.show("shown", "lowest head after 1 d", *std::min_element(heads.begin(), heads.end()), "m");
  book.show("shown", "highest head after 1 d", *std::max_element(heads.begin(), heads.end()), "m");
}

void completes(CaseBook& book) {
  const auto history = book.solve("25 x 15 cells", kirkland(25));
  judge_run(book, history);
  book.draw(contours({{"25 x 15", history}}));
}

void on_three_meshes(CaseBook& book) {
  std::vector<std::pair<std::string, meshes::FieldHistory>> runs;
  for (const int along : {25, 50, 100}) {
    const std::string label = fmt::format("{} x {} cells", along, along * 3 / 5);
    runs.emplace_back(label, book.solve(label, kirkland(along)));
  }
  judge_run(book, runs.back().second);
  const meshes::FieldHistory& finest = runs.back().second;
  for (const double level : {0.0, -400.0})
    for (std::size_t r = 0; r + 1 < runs.size(); ++r) {
      const auto a = contour(runs[r].second, finest.mesh, level), b = contour(finest, finest.mesh, level);
      const auto text =
          fmt::format("contour of {} m: largest distance from {} to {}", level, runs[r].first, runs.back().first);
      const Gate gate{
          0.1, "m",
          "gate R9: within 0.1 m; against cells half as large (against a quarter, 357 CPU s: 0.055 and 0.115 m)"};
      if (r + 2 == runs.size())
        book.judge("front", text, std::max(one_way(a, b), one_way(b, a)), gate);
      else
        book.show("shown", text, std::max(one_way(a, b), one_way(b, a)), "m");
    }
  book.draw(contours(runs));
}

}  // namespace

std::vector<Case> kirkland_cases() {
  const std::string source = "Kirkland, Hills & Wierenga 1992; Forsyth, Wu & Pruess 1995; data as in frehg2 b3.";
  return {
      {"kirkland_completes", "R9 Kirkland, layered and dry at -500 m, coarse",
       "Water irrigated onto very dry layers is followed to the end of the day.", source, Effort::everyday, completes},
      {"kirkland_contours", "R9 Kirkland, layered and dry at -500 m, three meshes",
       "The fronts in very dry layers stand where a mesh twice as fine puts them.", source, Effort::heavy,
       on_three_meshes}};
}

}  // namespace wetfront::verification
