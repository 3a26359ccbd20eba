#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/closed_form_on_points.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/on_points.h"
#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

double worst_error(const ClosedFormCase& exact, int cells, CaseBook& book) {
  mpm::Problem<2> problem = on_points(exact.problem(cells));
  problem.stages[0].time_tolerance = 1e-7;
  const auto errors = head_errors(book.solve(fmt::format("{}, {} cells", exact.name, cells), problem), exact, false);
  return *std::ranges::max_element(errors);
}

void slopes(CaseBook& book) {
  auto figure = figure_frame({"error_over_angle", "Error over the inclination", "Convergence"}, {"inclination", "deg"},
                             {"worst relative L2 of the head", "-"});
  auto coarse = line("25 cells"), fine = line("50 cells");
  for (const double degrees : {0., 15., 30., 45.}) {
    const auto exact = sloping_layer_case(degrees);
    put(coarse, degrees, worst_error(exact, 25, book));
    put(fine, degrees, worst_error(exact, 50, book));
    book.judge_order("order", fmt::format("observed order between 25 and 50 cells, {:g} degrees", degrees),
                     std::log2(coarse.y.back() / fine.y.back()), {1.8, 2.2, "linear cells are of second order"});
    book.judge("error", fmt::format("error at {:g} degrees over that of the horizontal layer, 50 cells", degrees),
               fine.y.back() / fine.y.front(),
               {1.1, "1", "a slope must be as accurate as the horizontal layer; its own cos scales the heads"});
  }
  figure.series = {coarse, fine};
  book.draw(figure);
}

}  // namespace

std::vector<Case> slope_cases() {
  return {{"sloping_layers", "Rain on infinite slopes of 0 to 45 degrees, periodic sides",
           "A layer on a slope wets as accurately as a horizontal one.",
           "Srivastava & Yeh 1991 with the transform of Iverson 2000, WRR 36:1897.", Effort::everyday, slopes}};
}

}  // namespace wetfront::verification
