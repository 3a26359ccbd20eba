#include "mpm/simulation.h"
#include "verification/compare/profile.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/on_points.h"
#include "verification/suites/seed_column.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double height = 1.2;  // m, of the soil
constexpr int cells = 40;       // the topmost filled to the share f
const std::vector<double> shares = {0.25, 0.5, 0.75};
const std::vector<double> fractions = {0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98};

/// The paper's column on a background grid whose top row it fills to the share f.
mpm::Problem<2> column_in_grid(const SeedColumn& sand, double f, mpm::RainScheme rain) {
  auto reference = sand.problem(cells, shares);
  const double stretch = cells / (cells - 1 + f);
  for (auto& node : reference.mesh.nodes) node[0] *= stretch;
  for (std::size_t i = 0; i < reference.mesh.node_count(); ++i)
    reference.initial_head[i] = std::max(-reference.mesh.nodes[i][0], -10e3 / reference.unit_weight);
  mpm::Problem<2> problem = on_points(reference);
  const double width = problem.mesh.nodes[1][0];
  problem.surface = {{0, height, 0}, {width, height, 0}};
  problem.water_boundary = {mpm::RainSide{mpm::free_surface, {{0}, {sand.rain}}, "case: rain"}};
  problem.rain_scheme = rain;
  return problem;
}

/// Relative L2 of the pressure at the nodes inside the soil, the worst time.
double worst_error(const meshes::FieldHistory& ours, const meshes::FieldHistory& reference) {
  const auto weight = node_weights(ours.mesh, reference.mesh);
  const auto expected = pressure_at_nodes(reference, ours.mesh);
  double worst = 0;
  for (std::size_t t = 0; t < expected.size(); ++t)
    worst = std::max(worst, relative_l2(ours.snapshots[t].node_pressure, expected[t], weight));
  return worst;
}

struct Variant {
  const char* name;
  mpm::RainScheme scheme;
};
constexpr Variant variants[] = {{"Martinelli 2020", mpm::RainScheme::martinelli_2020},
                                {"Bandara 2016", mpm::RainScheme::bandara_2016},
                                {"consistent flux", mpm::RainScheme::consistent_flux}};

void inside(double rain, CaseBook& book) {
  const SeedColumn sand{rain};
  auto fine = sand.problem(320, shares);
  const auto reference = book.solve("reference, 320 cells", fine);
  const double aligned = worst_error(book.solve("aligned", on_points(sand.problem(cells, shares))), reference);
  book.show("shown", "relative L2 at the nodes, surface on grid nodes", aligned, "1");
  auto figure = figure_frame({"error_over_fraction", "Error over the filled share of the topmost cell", "Convergence"},
                             {"f", "-"}, {"relative L2 of the nodal pressure", "-"});
  figure.log_y = true;
  auto standard = line("standard"), on_nodes = dashed("surface on grid nodes");
  for (const double f : fractions) {
    const auto run = book.solve(fmt::format("f = {:g}", f), column_in_grid(sand, f, mpm::RainScheme::standard));
    put(standard, f, worst_error(run, reference));
    put(on_nodes, f, aligned);
    book.judge("error", fmt::format("relative L2 at the nodes, f = {:g}", f), standard.y.back(),
               {std::max(2 * aligned, 3e-3), "1", "twice that of the aligned surface, or 0.3 %"});
  }
  figure.series = {standard, on_nodes};
  for (const Variant& variant : variants) {
    auto curve = line(variant.name);
    for (const double f : {0.1, 0.5, 0.9}) {
      // Shown, not gated: run outside the book, whose balances are gates.
      const auto run = mpm::run(column_in_grid(sand, f, variant.scheme));
      book.spend(run.cpu_seconds);
      put(curve, f, worst_error(run, reference));
      book.show("shown", fmt::format("{}, f = {:g}: relative L2 at the nodes", variant.name, f), curve.y.back(), "1");
    }
    figure.series.push_back(curve);
  }
  book.draw(figure);
}

}  // namespace

std::vector<Case> surface_cases() {
  std::vector<Case> cases;
  for (const double rain : {3e-5, 1.5e-4})
    cases.push_back({fmt::format("surface_in_cell_{:g}", rain * 1e6),
                     fmt::format("Surface anywhere inside the top cell, rain {:g} m/s", rain),
                     "Where in a cell the surface lies costs no accuracy.",
                     "The paper's column, 40 cells, f = 0.02 to 0.98; named alternatives shown.", Effort::everyday,
                     [rain](CaseBook& book) { inside(rain, book); }});
  return cases;
}

}  // namespace wetfront::verification
