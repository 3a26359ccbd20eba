#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/closed_form_on_points.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/on_points.h"
#include "verification/suites/reference/celia_problem.h"

#include <fmt/format.h>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

using Builder = fem::RichardsProblem (*)(int cells);
using Judge = void (*)(CaseBook&, const meshes::FieldHistory&);

/// The printed tables, on a mesh on which the reference meets them too.
void tables(Builder build, int cells, double tolerance, Judge judge, CaseBook& book) {
  const fem::RichardsProblem reference = build(cells);
  mpm::Problem<2> problem = on_points(reference);
  problem.stages[0].time_tolerance = tolerance;
  const auto history = book.solve(fmt::format("{} cells, 4 points each", cells), problem);
  judge(book, on_line(history, reference.mesh));
}

const std::string source =
    "Celia, Bouloutas & Zarba 1990, WRR 26:1483; converged tables of the design notes (2.1); order against the "
    "reference on a finer mesh.";

}  // namespace

std::vector<Case> celia_water_cases() {
  OnPoints mexico;
  mexico.exact.name = "celia_new_mexico_order";
  mexico.exact.title = "Celia, New Mexico soil, order in h";
  mexico.exact.requirement = "A dry column wets to second order in the cell size.";
  mexico.exact.source = source;
  mexico.exact.problem = celia_new_mexico;
  mexico.ladder = {50, 100, 200};
  mexico.gate = {0.01, 200, "the front is two cells wide on 200 cells; behind it the error is a tenth of this"};
  mexico.order = {1.0, 2.2, "the start, 6 h, has a front narrower than the cells: between first and second order"};
  mexico.change_with_points = 0.1;  // 2 cm cells under a front of 1 cm: K bends within the cell
  mexico.reference_cells = 800;
  mexico.time_tolerance = 1e-7;
  mexico.reference_tolerance = 1e-6;
  mexico.effort = Effort::heavy;
  return {{"celia_sand", "Celia, sand, 360 s", "Haverkamp's sand wets as the converged table says.", source,
           Effort::quick, [](CaseBook& book) { tables(celia_sand, 160, 1e-5, judge_celia_sand, book); }},
          {"celia_new_mexico", "Celia, New Mexico soil, 24 h", "A dry column wets as the converged table says.", source,
           Effort::everyday, [](CaseBook& book) { tables(celia_new_mexico, 400, 1e-4, judge_celia_new_mexico, book); }},
          as_case(mexico)};
}

}  // namespace wetfront::verification
