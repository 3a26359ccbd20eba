#include "verification/exact/sorptivity.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;
constexpr double driest = 0.01, face = 0.99, minute = 60;

struct HorizontalCase {
  const char *name, *title;
  exact::VanGenuchten soil;
  double printed;         ///< S [cm/d^1/2]
  double printed_middle;  ///< x where Se = 0.5 after 100 min [cm]
  double length;          ///< of the column [m]
  int cells;
};

/// The face is the column's top; x runs down from it.
void absorb(const HorizontalCase& in, CaseBook& book) {
  const exact::VanGenuchten& soil = in.soil;
  const exact::Sorptivity exact(soil, driest, face);
  fem::RichardsProblem problem = column(in.length, in.cells, soil.head_of_saturation(driest),
                                        {5 * minute, 10 * minute, 20 * minute, 50 * minute, 100 * minute});
  problem.gravity_direction = {};
  problem.soils = {van_genuchten_soil(soil)};
  problem.boundary = {fem::HeadSide{"top", soil.head_of_saturation(face)}};
  const auto history = book.solve(fmt::format("{} cells", in.cells), problem);
  const double to_printed_unit = std::sqrt(day) / cm;
  book.expect("error", "S of the closed form against the printed number [cm/d^1/2]", exact.value() * to_printed_unit,
              in.printed, {4e-7, "1", "five decimals are printed: 5e-6 of the smallest S, 12.98"});
  reports::Figure figure = figure_frame({"profiles", "Effective saturation over the similarity variable", "Profiles"},
                                        {"x / sqrt(t)", "cm/min^1/2"}, {"Se", "-"});
  reports::Series fixed_point = line("fixed point", 0);
  for (int k = 1; k < 100; ++k) {
    put(fixed_point, exact.position(0.01 * k) * std::sqrt(minute) / cm, driest + 0.01 * k * (face - driest));
  }
  figure.series.push_back(fixed_point);
  for (const auto& snapshot : history.snapshots) {
    double inflow = 0;
    for (const auto& row : history.ledger)
      if (row.time <= snapshot.time) inflow = -row.outflow;
    book.expect("infiltration", fmt::format("S from the inflow until {:g} min [cm/d^1/2]", snapshot.time / minute),
                inflow / std::sqrt(snapshot.time) * to_printed_unit, exact.value() * to_printed_unit,
                {5e-3, "1", "gate R5: within 0.5 %"});
    std::vector<double> saturation;
    for (const double head : heads_of(snapshot)) saturation.push_back(soil.saturation(head));
    reports::Series ours = points(fmt::format("reference, {:g} min", snapshot.time / minute));
    const double root = std::sqrt(snapshot.time);
    for (std::size_t i = 0; i < saturation.size(); i += 4) {
      const double x = (in.length - history.mesh.nodes[i][0]) / root * std::sqrt(minute) / cm;
      if (x < 1.3 * fixed_point.x.front()) put(ours, x, saturation[i]);
    }
    figure.series.push_back(ours);
    if (snapshot.time == history.snapshots.back().time)
      book.expect("front", "x where Se = 0.5 after 100 min [cm]",
                  (in.length - height_where(history.mesh, saturation, 0.5)) / cm, in.printed_middle,
                  {5e-3, "1", "gate R5's 0.5 %, applied to the printed place"});
  }
  book.draw(figure);
}

}  // namespace

std::vector<Case> sorptivity_cases() {
  const HorizontalCase soils[] = {
      {"sorptivity_hygiene",
       "Hygiene sandstone",
       {0.153, 0.250, 0.79, 10.4, 108 * cm_per_day},
       24.04224,
       72.4184,
       1.2,
       480},
      {"sorptivity_touchet",
       "Touchet silt loam",
       {0.190, 0.469, 0.5, 7.09, 303 * cm_per_day},
       96.43671,
       101.2154,
       1.8,
       480},
      {"sorptivity_ge3", "silt loam GE3", {0.131, 0.396, 0.423, 2.06, 4.96 * cm_per_day}, 12.98337, 14.5313, 0.4, 400}};
  std::vector<Case> cases;
  for (const HorizontalCase& soil : soils)
    cases.push_back({soil.name, fmt::format("R5 Horizontal absorption, {}", soil.title),
                     "Without gravity water enters as S sqrt(t), and the profile is one of x/sqrt(t).",
                     "Philip 1973, McWhorter & Sunada 1990, WRR 26:399; soils of Mathias & Sander as in openRE.",
                     Effort::everyday, [soil](CaseBook& book) { absorb(soil, book); }});
  return cases;
}

}  // namespace wetfront::verification
