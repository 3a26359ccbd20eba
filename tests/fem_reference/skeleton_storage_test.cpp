#include "fem_reference/soil/soil_law.h"
#include "tests/fem_reference/columns.h"
#include "verification/exact/terzaghi.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

Soil elastic(Soil soil, double modulus, Soil::Bishop bishop) {
  soil.oedometer_modulus = modulus;
  soil.bishop = bishop;
  return soil;
}

// Gardner's soil with theta_r = 0 has S = chi = Se = e^{a h}, so that the integral of S (chi + h chi') is
// h e^{2ah} / 2 + (e^{2ah} - 1) / (4 a).
TEST(SkeletonStorage, MatchesTheClosedFormOfGardnersSoil) {
  const double a = 2, modulus = 1e6, gamma = 9000;
  const Soil rigid{"g", ExponentialRetention{0, 0.4, a}, ExponentialConductivity{a}, 1e-5, 0, 0};
  for (auto bishop : {Soil::Bishop::saturation, Soil::Bishop::effective_saturation}) {
    const SoilLaw law(elastic(rigid, modulus, bishop), gamma), plain(rigid, gamma);
    for (double h : {-30.0, -4.0, -1.0, -0.3, -1e-3, -1e-5, 0.0, 0.7}) {
      const double expected = h > 0 ? h : h * std::exp(2 * a * h) / 2 + std::expm1(2 * a * h) / (4 * a);
      const double ours = (law.storage(h).value - plain.storage(h).value) * modulus / gamma;
      EXPECT_NEAR(ours, expected, 1e-12 + 1e-14 * modulus / gamma) << h;
    }
  }
}

// Against Simpson's rule on S (chi + p dchi/dp) / E written out with van Genuchten's curve, S_max < 1.
TEST(SkeletonStorage, MatchesQuadratureOfVanGenuchtensSoil) {
  Soil soil{"l", VanGenuchten{0.08, 0.40, 4.0, 1.6}, MualemConductivity{}, 5.8e-6, 0, 0.43};
  const auto content = [](double h) { return 0.08 + 0.32 * std::pow(1 + std::pow(-4 * h, 1.6), -0.375); };
  for (auto bishop : {Soil::Bishop::saturation, Soil::Bishop::effective_saturation}) {
    const SoilLaw law(elastic(soil, 2e6, bishop)), rigid(soil);
    const auto chi = [&](double h) {
      return bishop == Soil::Bishop::saturation ? content(h) / 0.43 : (content(h) - 0.08) / 0.32;
    };
    const auto rate = [&](double h) {
      const double step = 1e-5 * h;
      const double slope = (chi(h + step) * (h + step) - chi(h - step) * (h - step)) / (2 * step);
      return content(h) / 0.43 * slope * 9810 / 2e6;
    };
    const int pieces = 2000;
    double integral = 0;
    for (int i = 0; i < pieces; ++i) {
      const double from = -3 + 2.9 * i / pieces, to = -3 + 2.9 * (i + 1) / pieces;
      integral += (to - from) / 6 * (rate(from) + 4 * rate(0.5 * (from + to)) + rate(to));
    }
    const auto taken = [&](double h) { return law.storage(h).value - rigid.storage(h).value; };
    EXPECT_NEAR(taken(-0.1) - taken(-3), integral, 1e-10);
    // Saturated: S_max chi_max / E for each.
    const double full = bishop == Soil::Bishop::saturation ? 0.40 / 0.43 * 0.40 / 0.43 : 0.40 / 0.43;
    EXPECT_NEAR(taken(2.0) - taken(1.0), full * 9810 / 2e6, 1e-12);
  }
}

TEST(SkeletonStorage, SlopeIsTheDerivative) {
  const SoilLaw law(elastic(seed_sand(0.087), 1e6, Soil::Bishop::saturation));
  for (double h : {-900.0, -20.0, -3.0, -1.0, -0.3, -0.02, 0.7}) {
    const double step = 1e-5 * std::abs(h);
    const double difference = (law.storage(h + step).value - law.storage(h - step).value) / (2 * step);
    EXPECT_NEAR(law.storage(h).slope, difference, 1e-6 * difference + 1e-16 / step) << h;
  }
}

// chi + p dchi/dp < 0 where a soil with n > 2 is dry: W would fall. Refused where the problem goes there, and nowhere
// does W fall.
TEST(SkeletonStorage, WaterNeverFallsWithTheHead) {
  const Soil soft = elastic(seed_sand(0.087), 1e5, Soil::Bishop::effective_saturation);
  const SoilLaw law(soft);
  EXPECT_LT(law.skeleton_limit(), -10);
  EXPECT_GT(law.skeleton_limit(), -1000);
  double last = -1e9;
  for (double h = -5000; h < 1; h += 0.37) {
    EXPECT_GE(law.storage(h).value, last) << h;
    last = law.storage(h).value;
  }
  RichardsProblem problem = seed_column(10, 0.087, 0, 1);
  problem.soils = {soft};
  EXPECT_NO_THROW(solve(problem));
  problem.initial_head[0] = -1000;
  try {
    solve(problem);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("soils[0] 'sand'.oedometer_modulus"));
  }
}

// A saturated layer, no gravity, drained at the top: Terzaghi with stiff water, c_v = K / (gamma / E + sigma).
TEST(SkeletonStorage, ConsolidatesLikeTerzaghi) {
  const double modulus = 5e6, sigma = 2e-4, conductivity = 1e-7, initial = 3;
  RichardsProblem problem;
  problem.mesh = line_mesh(100, 2);
  problem.soils = {elastic(seed_sand(0.087, sigma), modulus, Soil::Bishop::saturation)};
  problem.soils[0].saturated_conductivity = conductivity;
  problem.initial_head.assign(101, initial);
  problem.boundary = {HeadSide{"top", 0}};
  const double cv = conductivity / (problem.unit_weight / modulus + sigma);
  for (double factor : {0.05, 0.2, 0.5, 1.0}) problem.output_times.push_back(factor * 4 / cv);
  problem.end_time = problem.output_times.back();
  const meshes::FieldHistory history = solve(problem);
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    for (int i = 0; i <= 100; i += 10) {
      const double expected = initial * verification::exact::terzaghi_pressure(1 - i / 100.0, cv * snapshot.time / 4);
      // 100 linear cells on the sine of half a wave: (pi / 200)^2 / 12 = 2e-5, more while the front is young.
      EXPECT_NEAR(snapshot.node_pressure[i] / problem.unit_weight, expected, 1e-3) << snapshot.time << ' ' << i;
    }
  }
  EXPECT_LE(worst_imbalance(history), 1e-8);
}

}  // namespace
}  // namespace wetfront::fem_reference
