// Infiltration into dry soil without a closed form of the whole: held against bounds, against the wave it tends to, and
// against the reference's own solution on a mesh four times finer.
#include "verification/exact/sorptivity.h"
#include "verification/exact/travelling_wave.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

/// Water that came in by the time of a snapshot [m^(dim - 1) m].
double taken_until(const meshes::FieldHistory& history, double time) {
  double taken = 0;
  for (const auto& row : history.ledger)
    if (row.time <= time) taken = row.infiltrated - row.outflow;
  return taken;
}

reports::Figure profiles(const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine) {
  reports::Figure figure = figure_frame({"profiles", "Pressure head over elevation on two meshes", "Profiles"},
                                        {"pressure head", "m"}, {"elevation", "m"});
  for (std::size_t s = 0; s < fine.snapshots.size(); ++s) {
    const std::string at = fmt::format("{:.4g} d", fine.snapshots[s].time / day);
    reports::Series under = line("four times finer, " + at, static_cast<int>(s));
    reports::Series over = points("judged mesh, " + at, static_cast<int>(s));
    const auto h = heads_of(coarse.snapshots[s]), H = heads_of(fine.snapshots[s]);
    for (std::size_t i = 0; i < H.size(); ++i) put(under, H[i], fine.mesh.nodes[i][0]);
    for (std::size_t i = 0; i < h.size(); i += 4) put(over, h[i], coarse.mesh.nodes[i][0]);
    figure.series.insert(figure.series.end(), {under, over});
  }
  return figure;
}

/// Front (where the head passes `level`) within 0.5 cm and water taken within 0.1 %: R8's gates, for any such column.
void judge_columns(CaseBook& book, const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine, double level) {
  for (std::size_t s = 0; s < fine.snapshots.size(); ++s) {
    const double time = fine.snapshots[s].time;
    const auto front = [&](const meshes::FieldHistory& h) {
      return height_where(h.mesh, heads_of(h.snapshots[s]), level) / cm;
    };
    book.expect("front", fmt::format("height of the head {:.4g} m after {:.4g} d [cm]", level, time / day),
                front(coarse), front(fine), {0.5, "cm", "R8's gate on a front, against a mesh four times finer"});
    book.expect("infiltration", fmt::format("water taken up after {:.4g} d [m]", time / day), taken_until(coarse, time),
                taken_until(fine, time), {1e-3, "1", "R8's gate on infiltration, against a mesh four times finer"});
  }
  book.draw(profiles(coarse, fine));
}

const exact::VanGenuchten yolo_clay{0.124, 0.495, 2.6, 1.43, 0.0443 * cm_per_hour};

fem::RichardsProblem yolo_problem(int cells) {
  const double dry = yolo_clay.head_of_saturation((0.24 - 0.124) / (0.495 - 0.124));
  fem::RichardsProblem problem = column(1.5, cells, dry, {1e4, 1e5, 1e6});
  // Cells grow with the root of depth: water has gone 2 cm by 1e4 s, and K falls steeply right under the surface.
  for (auto& node : problem.mesh.nodes) node[0] = 1.5 * (1 - std::pow(1 - node[0] / 1.5, 2));
  problem.soils = {van_genuchten_soil(yolo_clay)};
  problem.boundary = {fem::HeadSide{"top", yolo_clay.head_of_saturation(0.99)}, fem::HeadSide{"base", dry}};
  return problem;
}

void yolo(CaseBook& book) {
  const double driest = (0.24 - 0.124) / (0.495 - 0.124), face = yolo_clay.head_of_saturation(0.99);
  const auto coarse = book.solve("300 cells", yolo_problem(300)), fine = book.solve("1200 cells", yolo_problem(1200));
  judge_columns(book, coarse, fine, yolo_clay.head_of_saturation(0.5 * (driest + 0.99)));
  // Philip 1957: S sqrt(t) <= I <= S sqrt(t) + K t.
  const double sorptivity = exact::Sorptivity(yolo_clay, driest, 0.99).value();
  const double conductivity = yolo_clay.conductivity * yolo_clay.relative_conductivity(face);
  for (const double time : {1e4, 1e5, 1e6}) {
    const double low = sorptivity * std::sqrt(time), high = low + conductivity * time,
                 taken = taken_until(coarse, time);
    book.judge("infiltration",
               fmt::format("water taken up after {:g} s: {:.4f} cm, within Philip's bounds {:.4f} and {:.4f}", time,
                           taken / cm, low / cm, high / cm),
               std::abs(taken - 0.5 * (low + high)), {0.5 * (high - low), "m", "gravity adds between nothing and K t"});
  }
}

/// 6 m of soil as MOOSE's rd01 and rd02 have it: gravity 10 m/s2.
const exact::VanGenuchten caisson{0, 0.33, 1.43, 1 / (1 - 0.336), 2.95e-13 * 1e4 / 1.01e-3};
constexpr double caisson_weight = 1e4, caisson_dry = -72620.4 / caisson_weight, recharge = 2.315e-6;

fem::RichardsProblem caisson_problem(int cells, bool wetting) {
  fem::RichardsProblem problem = wetting ? column(6, cells, caisson_dry, {2.08 * day, 4.16 * day})
                                         : column(6, cells, 0, {1 * day, 4 * day, 20 * day, 100 * day});
  problem.soils = {van_genuchten_soil(caisson)};
  problem.tolerance = 1e-5;
  problem.soils[0].specific_storage = 0.33 * caisson_weight / 2e7;  // MOOSE's water: 20 MPa
  if (wetting)
    problem.boundary = {fem::RainSide{"top", {{0}, {recharge}}}};
  else
    problem.boundary = {fem::HeadSide{"base", 0}};
  return problem;
}

void recharge_caisson(CaseBook& book) {
  const auto coarse = book.solve("320 cells", caisson_problem(320, true));
  const auto fine = book.solve("1280 cells", caisson_problem(1280, true));
  const auto wave = exact::TravellingWave::from_rate(caisson, recharge, caisson_dry);
  judge_columns(book, coarse, fine, wave.head_at_fraction(0.5));
  const auto middle = [&](std::size_t s) {
    return height_where(coarse.mesh, heads_of(coarse.snapshots[s]), wave.head_at_fraction(0.5));
  };
  book.expect("front", "mean speed of the middle of the front from 2.08 to 4.16 d [cm/d]",
              (middle(0) - middle(1)) / (2.08 * day) / cm_per_day, wave.speed() / cm_per_day,
              {0.02, "1", "the wave is still forming: a front of 1/alpha = 0.7 m after 2 m of travel"});
}

void drain_caisson(CaseBook& book) {
  const auto coarse = book.solve("240 cells", caisson_problem(240, false));
  const auto fine = book.solve("960 cells", caisson_problem(960, false));
  for (std::size_t s = 0; s < 4; ++s) {
    const double time = fine.snapshots[s].time;
    const auto h = heads_of(coarse.snapshots[s]), H = heads_of(fine.snapshots[s]);
    double worst = 0;
    for (std::size_t i = 0; i < h.size(); ++i) worst = std::max(worst, std::abs(h[i] - H[4 * i]));
    book.judge("error", fmt::format("largest difference of the heads after {:g} d", time / day), worst / cm,
               {0.5, "cm", "R8's gate on heads, against a mesh four times finer"});
    book.expect("infiltration", fmt::format("water drained after {:g} d [m]", time / day), -taken_until(coarse, time),
                -taken_until(fine, time), {1e-3, "1", "R8's gate on infiltration, against a mesh four times finer"});
  }
  book.draw(profiles(coarse, fine));
}

/// Forsyth, Wu & Pruess 1995, problem 2 as in ParFlow: K = k / mu with k in cm2 (its gravity is 1), mu = 0.01124.
fem::RichardsProblem forsyth(int refinement) {
  fem::RichardsProblem problem;
  problem.mesh = rectangle_mesh(8, 6.5, 32 * refinement, 65 * refinement);
  name_regions(problem.mesh, {"zone 1", "zone 2", "zone 3", "zone 4"}, [](const meshes::Point& at) {
    if (at[1] > 6.1) return 0;
    if (at[1] > 5.6) return 1;
    return at[0] > 1 && at[0] < 3 && at[1] > 4 && at[1] < 5 ? 3 : 2;
  });
  split_side(problem.mesh, "top", "strip", [](const meshes::Point& at) { return at[0] < 2.25; });
  const auto soil = [](double k, double porosity, double alpha_per_cm, double n, double residual) {
    return van_genuchten_soil({residual * porosity, porosity, 100 * alpha_per_cm, n, k / 0.01124 * cm});
  };
  problem.soils = {soil(9.1496e-5, 0.368, 0.0334, 1.982, 0.2771), soil(5.4427e-5, 0.351, 0.0363, 1.632, 0.2806),
                   soil(4.8033e-5, 0.325, 0.0345, 1.573, 0.2643), soil(4.8033e-4, 0.325, 0.0345, 1.573, 0.2643)};
  problem.gravity_direction = {0, -1, 0};
  problem.boundary = {fem::FluxSide{"strip", {{0}, {2 * cm_per_day}}}};
  problem.initial_head.assign(problem.mesh.node_count(), -7.34);
  problem.output_times = {10 * day, 30 * day};
  problem.end_time = 30 * day;
  problem.tolerance = 1e-4;
  return problem;
}

/// Saturations of one snapshot on the nodes that two meshes share: those of the coarse one.
void judge_forsyth(CaseBook& book, const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine) {
  std::map<std::pair<long, long>, std::size_t> place;
  const auto key = [](const meshes::Point& at) {
    return std::pair(std::lround(at[0] * 1e4), std::lround(at[1] * 1e4));
  };
  for (std::size_t i = 0; i < fine.mesh.node_count(); ++i) place[key(fine.mesh.nodes[i])] = i;
  for (std::size_t s = 0; s < 2; ++s) {
    double squares = 0;
    for (std::size_t i = 0; i < coarse.mesh.node_count(); ++i)
      squares += std::pow(coarse.snapshots[s].node_saturation[i] -
                              fine.snapshots[s].node_saturation[place.at(key(coarse.mesh.nodes[i]))],
                          2);
    book.judge("error", fmt::format("rms difference of the saturation after {:g} d", fine.snapshots[s].time / day),
               std::sqrt(squares / coarse.mesh.node_count()),
               {0.01, "-", "a hundredth of saturation on a mesh of 25 x 10 cm, against one twice finer"});
  }
  book.expect("infiltration", "water taken up [m2]", coarse.ledger.back().infiltrated, 2.25 * 0.6,
              {1e-9, "1", "2 cm/d over 2.25 m for 30 d, of which nothing may run off"});
}

reports::Figure forsyth_profiles(const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine) {
  auto figure = figure_frame({"profiles", "Saturation over elevation at x = 2 m after 30 d", "Profiles"},
                             {"saturation", "-"}, {"elevation", "m"});
  for (const auto* run : {&coarse, &fine}) {
    reports::Series series = run == &coarse ? points("32 x 65 cells", 0) : line("64 x 130 cells", 0);
    for (std::size_t i = 0; i < run->mesh.node_count(); ++i)
      if (std::abs(run->mesh.nodes[i][0] - 2) < 1e-9)
        put(series, run->snapshots.back().node_saturation[i], run->mesh.nodes[i][1]);
    figure.series.push_back(series);
  }
  return figure;
}

void forsyth_case(CaseBook& book) {
  const auto coarse = book.solve("32 x 65 cells", forsyth(1)), fine = book.solve("64 x 130 cells", forsyth(2));
  judge_forsyth(book, coarse, fine);
  book.draw(forsyth_profiles(coarse, fine));
}

}  // namespace

std::vector<Case> dry_soil_cases() {
  return {{"yolo_clay", "Yolo clay, 1e4 to 1e6 s", "A clay wets between Philip's bounds, the same on a finer mesh.",
           "Haverkamp et al. 1977, Philip 1957; van Genuchten fit of openRE.", Effort::everyday, yolo},
          {"caisson_recharge", "Caisson, recharge of a dry column for 4.16 d",
           "A column of 6 m wets as the travelling wave says, the same on a finer mesh.",
           "Forsyth et al. 1995; MOOSE richards rd01.", Effort::everyday, recharge_caisson},
          {"caisson_drainage", "Caisson, drainage of a full column for 100 d",
           "A full column drains to the water table at its base, the same on a finer mesh.",
           "Forsyth et al. 1995; MOOSE richards rd02.", Effort::everyday, drain_caisson},
          {"forsyth_2", "Forsyth problem 2, four zones, 30 d",
           "Infiltration over a strip spreads through four soils, the same on a finer mesh.",
           "Forsyth, Wu & Pruess 1995, Adv. Water Resour. 18:25; data of ParFlow's forsyth2.py.", Effort::heavy,
           forsyth_case}};
}

}  // namespace wetfront::verification
