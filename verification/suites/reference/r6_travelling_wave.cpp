#include "verification/exact/travelling_wave.h"
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

struct WaveCase {
  const char *name, *title;
  exact::VanGenuchten soil;
  double rate;   ///< of the wave [m/s]
  double ahead;  ///< head [m]
  std::vector<double> times;
  double depth;
  int cells;
  double start = 0;  ///< depth of the wave's middle at t = 0; 0: a dry column instead, under rain from t = 0 on
};

/// Depth of the place where the content has run through `fraction` of its rise.
double depth_of_fraction(const meshes::FieldHistory& history, std::size_t snapshot, const exact::TravellingWave& wave,
                         const WaveCase& in, double fraction) {
  return in.depth - height_where(history.mesh, heads_of(history.snapshots[snapshot]), wave.head_at_fraction(fraction));
}

/// Heads of the closed form, constant where it is flat.
double wave_head(const exact::TravellingWave& wave, const WaveCase& in, double offset) {
  if (offset <= wave.offset_at_fraction(1 - 1e-6)) return wave.head_behind();
  if (offset >= wave.offset_at_fraction(1e-6)) return in.ahead;
  return wave.head(offset);
}

fem::RichardsProblem wave_problem(const WaveCase& in, const exact::TravellingWave& wave) {
  fem::RichardsProblem problem = column(in.depth, in.cells, in.ahead, in.times);
  problem.soils = {van_genuchten_soil(in.soil)};
  problem.boundary = {fem::RainSide{"top", {{0}, {in.rate}}}, fem::HeadSide{"base", in.ahead}};
  problem.tolerance = 1e-5;  // 0.5 % of a speed; the front's thickness over a cell decides, not the step
  if (in.start > 0)
    start_from(problem, [&](const meshes::Point& at) { return wave_head(wave, in, in.depth - at[0] - in.start); });
  return problem;
}

reports::Figure shape(const meshes::FieldHistory& history, const exact::TravellingWave& wave, const WaveCase& in) {
  reports::Figure figure =
      figure_frame({"profiles", "Pressure head over the distance from the middle of the front", "Profiles"},
                   {"distance, downward", "cm"}, {"pressure head", "m"});
  reports::Series exact = line("closed form", 0);
  for (double offset = -0.15; offset <= 0.05; offset += 0.0005) put(exact, offset / cm, wave_head(wave, in, offset));
  figure.series.push_back(exact);
  for (std::size_t s = 0; s < history.snapshots.size(); ++s) {
    const double middle = depth_of_fraction(history, s, wave, in, 0.5);
    reports::Series ours = points(fmt::format("reference, {:g} d", in.times[s] / day));
    const auto heads = heads_of(history.snapshots[s]);
    for (std::size_t i = 0; i < heads.size(); ++i) {
      const double offset = in.depth - history.mesh.nodes[i][0] - middle;
      if (offset > -0.15 && offset < 0.05) put(ours, offset / cm, heads[i]);
    }
    figure.series.push_back(ours);
  }
  return figure;
}

void travel(const WaveCase& in, CaseBook& book) {
  const auto wave = exact::TravellingWave::from_rate(in.soil, in.rate, in.ahead);
  const auto history = book.solve(fmt::format("{} cells", in.cells), wave_problem(in, wave));
  const std::size_t last = in.times.size() - 1;
  const auto middle = [&](std::size_t s) { return depth_of_fraction(history, s, wave, in, 0.5); };
  book.expect("front",
              fmt::format("speed of the middle of the front from {:g} to {:g} d [cm/d]", in.times[last - 1] / day,
                          in.times[last] / day),
              (middle(last) - middle(last - 1)) / (in.times[last] - in.times[last - 1]) / cm_per_day,
              wave.speed() / cm_per_day, {5e-3, "1", "gate R6: within 0.5 %"});
  for (const double fraction : {0.99, 0.9, 0.75, 0.25, 0.1, 0.01})
    book.expect("front", fmt::format("distance of fraction {:g} of the rise from the middle [cm]", fraction),
                (depth_of_fraction(history, last, wave, in, fraction) - middle(last)) / cm,
                wave.offset_at_fraction(fraction) / cm, {1, "cm", "gate R6: 1 cm"});
  if (in.start > 0)
    book.expect("front", fmt::format("depth of the middle after {:g} d [cm]", in.times[last] / day), middle(last) / cm,
                (in.start + wave.speed() * in.times[last]) / cm, {1, "cm", "gate R6's 1 cm, applied to the place"});
  book.draw(shape(history, wave, in));
}

}  // namespace

std::vector<Case> travelling_wave_cases() {
  const exact::VanGenuchten sand{0.045, 0.43, 15, 3, 1000 * cm_per_day}, loam{0.08, 0.43, 4, 1.6, 50 * cm_per_day};
  const WaveCase waves[] = {{"travelling_wave_sand",
                             "sand from a dry column",
                             sand,
                             100 * cm_per_day,
                             -4,
                             {.1 * day, .2 * day, .3 * day},
                             1.6,
                             640},
                            {"travelling_wave_loam",
                             "loam, the wave itself",
                             loam,
                             0.998 * 50 * cm_per_day,
                             -4,
                             {.2 * day, .5 * day, 1 * day},
                             2.4,
                             480,
                             0.4}};
  std::vector<Case> cases;
  for (const WaveCase& wave : waves)
    cases.push_back({wave.name, fmt::format("R6 Travelling wave M2.1, {}", wave.title),
                     "A wetting front in deep dry soil travels at the speed and in the shape of the quadrature.",
                     "Philip 1957; Vanderborght et al. 2005, VZJ 4:206, case M2.1.", Effort::heavy,
                     [wave](CaseBook& book) { travel(wave, book); }});
  return cases;
}

}  // namespace wetfront::verification
