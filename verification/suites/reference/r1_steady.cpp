#include "verification/exact/steady_infiltration.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/cpu_time.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// Steady rain on a column above a water table, and the head it should have.
struct SteadyCase {
  std::string name, title;
  fem::Soil soil;
  double height, rain, tolerance;
  std::string reason;
  std::function<double(double z)> head;
};

std::vector<double> steady(const SteadyCase& in, int cells, CaseBook& book) {
  fem::RichardsProblem problem = column(in.height, cells, 0, {1});
  problem.soils = {in.soil};
  problem.boundary = {fem::RainSide{"top", {{0}, {in.rain}}}, fem::HeadSide{"base", 0}};
  start_from(problem, [](const meshes::Point& at) { return -at[0]; });  // hydrostatic: knows nothing of the answer
  const CpuTime spent;
  auto heads = fem::steady_head(problem);
  book.spend(spent.seconds(), static_cast<double>(heads.size()));
  return heads;
}

void settle(const SteadyCase& in, CaseBook& book) {
  reports::Series exact = line("closed form", 0), ours = points("reference, 50 cells", 0);
  reports::Series measured = line("reference"), second = dashed("second order");
  for (const int cells : {50, 100, 200}) {
    const std::vector<double> heads = steady(in, cells, book);
    std::vector<double> expected;
    for (int i = 0; i <= cells; ++i) {
      expected.push_back(in.head(in.height * i / cells));
      if (cells != 50) continue;
      put(exact, expected.back(), in.height * i / cells);
      put(ours, heads[i], in.height * i / cells);
    }
    put(measured, cells, relative_l2(heads, expected));
    put(second, cells, measured.y.front() * std::pow(50.0 / cells, 2));
  }
  book.judge("error", "relative L2 of the head over the nodes, 200 cells", measured.y.back(),
             {in.tolerance, "1", in.reason});
  book.judge_order("order", "observed order between 100 and 200 cells", std::log2(measured.y[1] / measured.y[2]),
                   {1.9, 2.1, "gate R1 asks for order 2"});
  auto profile = figure_frame({"profiles", "Steady pressure head over elevation", "Profiles"}, {"pressure head", "m"},
                              {"elevation", "m"});
  profile.series = {exact, ours};
  auto convergence = figure_frame({"error_over_cells", "Relative L2 error over the number of cells", "Convergence"},
                                  {"cells", "-"}, {"relative L2 error", "-"});
  convergence.log_x = convergence.log_y = true;
  convergence.series = {measured, second};
  book.draw(profile);
  book.draw(convergence);
}

SteadyCase gardner(double alpha, double relative_rain) {
  const double conductivity = cm_per_hour;
  const exact::SteadyGardner solution{alpha, conductivity, relative_rain * conductivity};
  return {fmt::format("steady_gardner_{:g}_{:g}", alpha, 100 * relative_rain),
          fmt::format("R1 Steady rain of {:g} Ks, Gardner, alpha L = {:g}", relative_rain, alpha),
          gardner_soil(0.06, 0.40, alpha, conductivity),
          1.0,
          solution.flux,
          alpha > 1 ? 5e-5 : 2e-6,
          alpha > 1 ? "gate R1: 5e-5 at alpha L = 10, 200 cells" : "gate R1: 2e-6 at alpha L = 1, 200 cells",
          [solution](double z) { return solution.head(z); }};
}

SteadyCase seed_soil(double relative_rain) {
  // the seed paper's sand: p0 = 4.35 kPa, lambda = 0.61
  const exact::VanGenuchten sand{0.46 * 0.087, 0.46, 9810 / 4350.0, 1 / (1 - 0.61), 2.943e-4};
  const auto solution = std::make_shared<exact::SteadyVanGenuchten>(sand, relative_rain * sand.conductivity);
  return {fmt::format("steady_van_genuchten_{:.0f}", 100 * relative_rain),
          fmt::format("R1 Steady rain of {:.3g} Ks, van Genuchten", relative_rain),
          van_genuchten_soil(sand),
          1.2,
          relative_rain * sand.conductivity,
          5e-5,
          "gate R1's 5e-5: alpha L = 2.7 lies between its two numbers",
          [solution](double z) { return solution->head(z); }};
}

}  // namespace

std::vector<Case> steady_cases() {
  std::vector<Case> cases;
  for (const SteadyCase& in : {gardner(1, 0.1), gardner(1, 0.9), gardner(10, 0.1), gardner(10, 0.9),
                               seed_soil(3e-5 / 2.943e-4), seed_soil(0.5)})
    cases.push_back({in.name, in.title,
                     "Under steady rain the head is the closed form's, found without a march in time.",
                     "Gardner 1958; Yeh 1989, WRR 25:2127; van Genuchten by quadrature of dz = dh/(1 - q/K).",
                     Effort::quick, [in](CaseBook& book) { settle(in, book); }});
  return cases;
}

}  // namespace wetfront::verification
