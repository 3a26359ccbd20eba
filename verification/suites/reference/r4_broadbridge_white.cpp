#include "verification/exact/broadbridge_white.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/broadbridge_white_problem.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

using namespace broadbridge_white_soil;

}  // namespace

fem::RichardsProblem broadbridge_white_column(double depth, int cells, double flux, const std::vector<double>& times) {
  std::vector<double> seconds;
  for (const double t : times) seconds.push_back(t * unit);
  fem::RichardsProblem problem = column(depth, cells, -1000, seconds);
  fem::Soil soil;
  soil.name = "Broadbridge-White";
  soil.retention = fem::BroadbridgeWhiteRetention{theta_n, theta_n + range, c, 1.0};
  soil.conductivity = fem::BroadbridgeWhiteConductivity{};
  soil.saturated_conductivity = conductivity;
  problem.soils = {soil};
  problem.boundary = {fem::RainSide{"top", {{0}, {flux * conductivity}}}};
  return problem;
}

namespace {

std::vector<double> saturations(const meshes::Snapshot& snapshot) {
  std::vector<double> values;
  for (const double s : snapshot.node_saturation) values.push_back(((theta_n + range) * s - theta_n) / range);
  return values;
}

void surface(CaseBook& book) {
  const double flux = 0.5, depth = 10;
  const exact::BroadbridgeWhite solution(c, flux);
  const auto problem = broadbridge_white_column(depth, 500, flux, {0.1, 0.5, 1, 2, 4, 10});
  const auto history = book.solve("500 cells", problem);
  reports::Figure figure = figure_frame({"profiles", "Relative content over depth", "Profiles"}, {"Theta", "-"},
                                        {"depth over sorptive length", "-"});
  int colour = 0;
  for (const auto& snapshot : history.snapshots) {
    const double t = snapshot.time / unit;
    const std::vector<double> theta = saturations(snapshot);
    book.judge("error",
               fmt::format("Theta at the surface at t* = {:g}: {:.6f}, exact {:.6f}", t, theta.back(),
                           solution.surface_saturation(t)),
               std::abs(theta.back() - solution.surface_saturation(t)), {1e-3, "-", "gate R4"});
    reports::Series ours = points(fmt::format("reference, t* = {:g}", t), colour);
    reports::Series exact = line(fmt::format("closed form, t* = {:g}", t), colour++);
    for (std::size_t i = 0; i < theta.size(); i += 5) {
      const double z = depth - problem.mesh.nodes[i][0];
      if (z > 8) continue;
      put(ours, theta[i], -z);
      put(exact, solution.saturation(z, t), -z);
    }
    figure.series.push_back(exact), figure.series.push_back(ours);
  }
  book.draw(figure);
}

void ponding(CaseBook& book) {
  const double flux = 2;
  const double expected = exact::BroadbridgeWhite(c, flux).time_to_ponding();
  reports::Series offered = dashed("offered"), taken = line("taken up");
  double last = 0;
  for (const int cells : {200, 400}) {
    const auto history = book.solve(fmt::format("{} cells", cells), broadbridge_white_column(3, cells, flux, {0.5}));
    double before = 0, found = -1;
    for (const auto& row : history.ledger) {
      if (row.run_off > 0 && found < 0) found = before;
      if (row.run_off == 0) before = row.time / unit;
    }
    if (cells == 400)
      for (const auto& row : history.ledger) {
        put(offered, row.time / unit, row.rain_asked / range);
        put(taken, row.time / unit, row.infiltrated / range);
      }
    last = found;
    if (cells == 200) book.show("shown", "t* of ponding on 200 cells", found, "-");
  }
  book.expect("front", "t* of the last step without run-off, 400 cells", last, expected,
              {5e-3, "1", "gate R4: within 0.5 %"});
  reports::Figure figure = figure_frame({"infiltration", "Rain offered and taken up", "Time series"}, {"t*", "-"},
                                        {"cumulative, over range of content", "m"});
  figure.series = {offered, taken};
  figure.note = fmt::format("ponding at {:.5f}, closed form {:.5f}", last, expected);
  book.draw(figure);
}

}  // namespace

std::vector<Case> broadbridge_white_cases() {
  const std::string source = "Broadbridge & White 1988, WRR 24:145-154, C = 1.5.";
  return {{"broadbridge_white_surface", "R4 Broadbridge-White, rain at half Ks",
           "A strongly nonlinear soil takes up constant rain as the closed form says.", source, Effort::quick, surface},
          {"broadbridge_white_ponding", "R4 Broadbridge-White, time to ponding at twice Ks",
           "The surface ponds when the closed form says that it saturates.", source, Effort::quick, ponding}};
}

}  // namespace wetfront::verification
