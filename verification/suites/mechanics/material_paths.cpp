#include "mpm/laws/material_driver.h"
#include "verification/exact/soil_strength.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/cpu_time.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_setups.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double degree = std::numbers::pi / 180, cell_pressure = 100e3;
const mpm::Elastic elastic{10e6, 0.3, "suite"};
const Gate paths{1e-10, "1",
                 "the return to the surface is closed form: round-off is all that is left (the issue's 1e-10)"};

mpm::Soil frictional(double friction, double cohesion, double dilatancy = 0) {
  return frictional_soil(1600, elastic, {friction * degree, cohesion, dilatancy * degree, {}, "suite"});
}

mpm::PathStart<3> isotropic(double pressure) {
  return {{-pressure, -pressure, -pressure, 0, 0, 0}};
}

/// Axial strain along z under a constant cell pressure.
mpm::PathLeg<3> triaxial(double axial_strain) {
  mpm::PathLeg<3> leg;
  leg.strain[2] = axial_strain;
  leg.stress[0] = leg.stress[1] = -cell_pressure;
  leg.steps = 60;
  return leg;
}

reports::Series stress_path(const std::vector<mpm::PathState<3>>& states, const std::string& label) {
  auto series = line(label);
  for (const auto& state : states)
    put(series, 100 * std::abs(state.strain[2]), mpm::pressure_and_shear(state.stress).q / 1e3);
  return series;
}

void mohr_coulomb(CaseBook& book) {
  const CpuTime cpu;
  auto figure = figure_frame({"triaxial", "Triaxial tests at 100 kPa", "Paths"}, {"axial strain", "%"},
                             {"deviator stress q", "kPa"});
  for (const auto& [phi, c, psi] : {std::array{34.0, 0.0, 0.0}, {34.0, 0.0, 34.0}, {30.0, 5e3, 0.0}}) {
    const auto states = mpm::drive<3>(frictional(phi, c, psi), isotropic(cell_pressure), {triaxial(-0.06)});
    const std::string text = fmt::format("phi {:g}, c {:g} kPa, psi {:g}", phi, c / 1e3, psi);
    book.expect("strength", "sigma_1 of triaxial compression [Pa], " + text, -states.back().stress[2],
                exact::triaxial_strength(phi * degree, c, cell_pressure), paths);
    figure.series.push_back(stress_path(states, "compression, " + text));
  }
  const auto ratio = [](const mpm::PathState<3>& state) {
    const auto [p, q] = mpm::pressure_and_shear(state.stress);
    return q / p;
  };
  const auto extended = mpm::drive<3>(frictional(34, 0), isotropic(cell_pressure), {triaxial(0.06)});
  book.expect("strength", "q/p' of triaxial extension, phi 34", ratio(extended.back()),
              exact::critical_slope_extension(34 * degree), paths);
  figure.series.push_back(stress_path(extended, "extension, phi 34"));
  mpm::PathLeg<2> shear;
  shear.stress[1] = -cell_pressure;
  shear.strain[3] = 0.2;
  shear.steps = 400;
  const auto sheared = mpm::drive<2>(frictional(34, 0), {{-100e3, -100e3, -100e3, 0}}, {shear});
  book.expect("strength", "tau/sigma_n of simple shear, phi 34, psi 0 (Davis: sin phi)",
              sheared.back().stress[3] / cell_pressure, exact::davis_friction(34 * degree, 0), paths);
  book.draw(figure);
  book.spend(cpu.seconds());
}

/// Plastic shear strain of a triaxial path, from the strains less what the stress explains elastically: not asked of
/// the law. Of an axial strain a and a radial one r, int sqrt(2/3 e:e) = 2/3 |a - r| as long as it only grows.
double plastic_shear(const mpm::PathState<3>& state) {
  const double deviator = state.stress[2] - state.stress[0],
               shear_modulus = elastic.young / (2 * (1 + elastic.poisson));
  return 2.0 / 3 * std::abs(state.strain[2] - state.strain[0] - deviator / (2 * shear_modulus));
}

/// Strength falls in straight lines with the plastic shear strain, then stays.
void softening(CaseBook& book) {
  const CpuTime cpu;
  const double range = 0.05;
  const mpm::MohrCoulomb peak{38 * degree, 6e3, 8 * degree, {}, "suite"}, residual{30 * degree, 1e3, 0, {}, "suite"};
  mpm::Soil soil = frictional(38, 6e3);
  soil.law = mpm::SofteningMohrCoulomb{peak, residual, range};
  auto path = triaxial(-0.15);
  path.steps = 300;
  const auto states = mpm::drive<3>(soil, isotropic(cell_pressure), {path});
  auto figure = figure_frame({"softening", "Triaxial test of a soil that softens, 100 kPa", "Paths"},
                             {"axial strain", "%"}, {"deviator stress q", "kPa"});
  auto exact = dashed("closed form of the plastic shear strain");
  double worst = 0, strained = 0;
  int falling = 0;
  for (const auto& state : states) {
    strained = plastic_shear(state);
    const double share = std::min(strained / range, 1.0);
    const double strength =
        exact::triaxial_strength((1 - share) * peak.friction + share * residual.friction,
                                 (1 - share) * peak.cohesion + share * residual.cohesion, cell_pressure);
    put(exact, 100 * std::abs(state.strain[2]), (strength - cell_pressure) / 1e3);
    if (strained < 1e-6) continue;  // elastic so far
    worst = std::max(worst, std::abs(-state.stress[2] / strength - 1));
    if (share < 1) ++falling;
  }
  book.judge(
      "strength",
      fmt::format("sigma_1 of triaxial compression against the strength of its plastic shear strain, {} states on the "
                  "way down and after",
                  falling),
      worst,
      {1e-10, "1",
       "backward Euler: the strength is that of the strain at the end of each step, to the residual of its iteration"});
  book.judge("range", "softening range over the plastic shear strain at the end", range / strained,
             {0.9, "1", "the path has to reach the residual strength"});
  book.judge("range", "states wanted on the way down over those there", 30.0 / std::max(falling, 1),
             {1, "1", "the path has to be on its way for a while"});
  figure.series = {exact, stress_path(states, "300 steps")};
  book.draw(figure);
  book.spend(cpu.seconds());
}

/// Cohesion and friction of Yerro et al. 2015 at a suction; wetting under load takes them back.
void suction(CaseBook& book) {
  const CpuTime cpu;
  const double cohesion = 2e3, most = 8e3, rate = 3, turn = 10 * degree, atmosphere = 100e3;
  const mpm::MohrCoulomb saturated{30 * degree, cohesion, 0, {}, "suite"};
  mpm::Soil soil = frictional(30, cohesion);
  soil.law = mpm::SuctionMohrCoulomb{saturated, most, rate, turn};
  const auto strength = [&](double s) {
    return exact::triaxial_strength(saturated.friction + turn * s / atmosphere,
                                    cohesion + most * (1 - std::exp(-rate * s / atmosphere)), cell_pressure);
  };
  auto figure = figure_frame({"suction", "Triaxial tests at 100 kPa, then wetted", "Paths"}, {"axial strain", "%"},
                             {"deviator stress q", "kPa"});
  for (const double s : {0.0, 10e3, 40e3, 80e3}) {
    auto start = isotropic(cell_pressure);
    start.suction = s;
    auto wetting = triaxial(0);
    wetting.suction = 0;
    const auto loading = triaxial(-0.06);
    const auto states = mpm::drive<3>(soil, start, {loading, wetting});
    const auto at_failure = static_cast<std::size_t>(loading.steps);
    book.expect("strength", fmt::format("sigma_1 of triaxial compression [Pa], suction {:g} kPa", s / 1e3),
                -states[at_failure].stress[2], strength(s), paths);
    if (s > 0)
      book.expect("wetted", fmt::format("the same [Pa], wetted at that strain from {:g} kPa", s / 1e3),
                  -states.back().stress[2], strength(0), paths);
    figure.series.push_back(stress_path(states, fmt::format("suction {:g} kPa", s / 1e3)));
  }
  book.draw(figure);
  book.spend(cpu.seconds());
}

void cam_clay(CaseBook& book) {
  const CpuTime cpu;
  const double p0 = 200e3, lambda = 0.2, kappa = 0.04, slope = 1.0;
  mpm::Soil soil = dry_soil(1600, 10e6, 0.3);
  soil.law = mpm::ModifiedCamClay{slope, lambda, kappa, 1.0, p0, 1000, "suite"};
  mpm::PathLeg<3> undrained;  // constant volume
  undrained.strain = {0.1, 0.1, -0.2, 0, 0, 0};
  const auto states = mpm::drive<3>(soil, isotropic(p0), {undrained});
  auto figure = figure_frame({"undrained", "Undrained compression of a normally consolidated sample", "Paths"},
                             {"mean effective stress", "kPa"}, {"deviator stress", "kPa"});
  auto critical = dashed("critical line"), path = points("100 steps"), exact = line("closed form");
  put(critical, 0, 0);
  put(critical, p0 / 1e3, slope * p0 / 1e3);
  double worst = 0;
  for (const auto& state : states) {
    const auto [mean, shear] = mpm::pressure_and_shear(state.stress);
    const double on_path = p0 * std::pow(1 + std::pow(shear / (mean * slope), 2), -(1 - kappa / lambda));
    worst = std::max(worst, std::abs(mean / on_path - 1));
    put(path, mean / 1e3, shear / 1e3);
    put(exact, on_path / 1e3, shear / 1e3);
  }
  book.judge("error", "mean effective stress along the path against p0 (1 + (q/Mp')^2)^-(1 - kappa/lambda), 100 steps",
             worst,
             {1e-10, "1", "without change of volume the return is algebraic in logarithms: Newton's residual is left"});
  const auto [p, q] = mpm::pressure_and_shear(states.back().stress);
  book.expect("end", "mean effective stress at the end [Pa]", p,
              exact::cam_clay_undrained_mean_stress(p0, lambda, kappa),
              {1e-3, "1", "20 % of axial strain end on the critical line but for an exponential tail"});
  book.expect("end", "q/p' at the end", q / p, slope, {1e-3, "1", "as above"});
  figure.series = {critical, exact, path};
  book.draw(figure);
  book.spend(cpu.seconds());
}

}  // namespace

std::vector<Case> material_path_cases() {
  return {{"mohr_coulomb_paths", "M2 Mohr-Coulomb, one point along paths",
           "Strength along triaxial and shear paths is that of Mohr and Coulomb to round-off.",
           "benchmarks.md section 6.", Effort::quick, mohr_coulomb},
          {"softening_paths", "M2 Mohr-Coulomb that softens, one point along a path",
           "Strength falls with the plastic shear strain from peak to residual, as the law says.",
           "Closed form: strength linear in the plastic shear strain; mpm/laws/README.md.", Effort::quick, softening},
          {"suction_paths", "M2 Mohr-Coulomb with suction, one point along paths",
           "Suction adds cohesion and friction; wetting takes them back.", "Yerro, Alonso & Pinyol 2015.",
           Effort::quick, suction},
          {"cam_clay_paths", "M2 Modified Cam-Clay, undrained path", "The undrained path ends on the critical line.",
           "Wood 1990, section 5.", Effort::quick, cam_clay}};
}

}  // namespace wetfront::verification
