// Plastic closed forms, contact, scalings of collapses, undrained and dynamic porous columns: printed numbers first.
#include "verification/exact/soil_strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/exact/derivative.h"
#include "tests/exact/printed.h"
#include "verification/exact/de_boer.h"
#include "verification/exact/granular_collapse.h"
#include "verification/exact/infinite_slope.h"
#include "verification/exact/terzaghi.h"
#include "verification/exact/undrained.h"

namespace wetfront::verification::exact {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(SoilStrength, PrintedNumbers) {
  expect_printed(triaxial_strength(34 * degree, 0, 100), 353.713204, 6);
  expect_printed(triaxial_strength(30 * degree, 5, 100), 317.320508, 6);
  expect_printed(critical_slope_compression(34 * degree), 1.374610, 6);
  expect_printed(critical_slope_extension(34 * degree), .942674, 6);
  expect_printed(davis_friction(34 * degree, 0), .559193, 6);
  expect_printed(davis_friction(34 * degree, 34 * degree), .674509, 6);
  const double factors[][3] = {{0, 5.14159265, 1},
                               {20, 14.83471178, 6.39939352},
                               {30, 30.13962779, 18.40112222},
                               {34, 42.16372612, 29.43979237}};
  for (const auto& row : factors) {
    expect_printed(bearing_factor_cohesion(row[0] * degree), row[1], 8);
    expect_printed(bearing_factor_surcharge(row[0] * degree), row[2], 8);
  }
  EXPECT_NEAR(bearing_factor_cohesion(1e-7), std::numbers::pi + 2, 1e-5);  // the limit, not a special case
}

TEST(SoilStrength, InfiniteSlopeOfTheSeedFailsByDavis) {
  const DrySlope seed{30 * degree, 34 * degree, 0};
  expect_printed(safety_of(seed), .969, 3);
  expect_printed(safety_of({30 * degree, 34 * degree, 34 * degree}), 1.168, 3);
  // cohesion: the depth at which c* = gamma z cos b (sin b - cos b tan phi*) is where safety passes 1
  const double beta = 40 * degree, phi = 20 * degree, c = 5e3;
  const double critical =
      davis_cohesion(phi, 0, c) / (18e3 * std::cos(beta) * (std::sin(beta) - std::cos(beta) * davis_friction(phi, 0)));
  EXPECT_NEAR(safety_of({beta, phi, 0, c, 18e3, critical}), 1, 1e-14);
  EXPECT_THROW(safety_of({0, phi, 0}), std::invalid_argument);
}

TEST(SoilStrength, BlockOnAnIncline) {
  const double rows[][2] = {
      {0, 4.905}, {.2, 3.20585816}, {std::tan(20 * degree), 1.81281473}, {.5, .65714539}, {.6, 0}};
  for (const auto& row : rows) expect_printed(sliding_acceleration(30 * degree, row[0], 9.81), row[1], 8);
}

TEST(SoilStrength, CamClayEndsOnTheCriticalLine) {
  // the undrained path p'/p0 = ((M^2 + eta^2)/M^2)^-(1 - kappa/lambda) at eta = M
  EXPECT_NEAR(cam_clay_undrained_mean_stress(200e3, 0.2, 0.04), 200e3 * std::pow(2.0, -0.8), 1e-9);
}

TEST(GranularCollapse, PrintedNumbers) {
  const double rows[][3] = {
      {.5, .6000, .5}, {1, 1.2, 1}, {3, 3.9522, 1.5518}, {5, 5.5556, 1.9037}, {10, 8.8190, 2.5119}};
  for (const auto& row : rows) {
    expect_printed(lube_plane(row[0]).run_out, row[1], 4);
    expect_printed(lube_plane(row[0]).height, row[2], 4);
  }
  expect_printed(lajeunesse_plane(8).height, 2, 12);
  expect_printed(lube_axisymmetric(1).run_out, 1.24, 12);
  expect_printed(lube_axisymmetric(4).run_out, 3.2, 12);
  for (double a = 0.1; a < 12; a += 0.01) EXPECT_GT(lube_plane(a + 0.01).run_out, lube_plane(a).run_out) << a;
}

TEST(Undrained, PrintedNumbers) {
  const double density = .54 * 2650 + .46 * 1000;
  expect_printed(undrained_wave_speed({13.4615e6, 2e9, .46}, density), 1518.66, 2);
  expect_printed(undrained_wave_speed({13.4615e6, .2e9, .46}, density), 486.87, 2);
  const double oedometer = 10e6 * .7 / (1.3 * .4);
  expect_printed(undrained_pressure({oedometer, .2e9, .4}, 1), .973783, 6);
  // one formula in two places: Terzaghi's start
  EXPECT_NEAR(undrained_pressure({oedometer, .2e9, .4}, 1e4),
              TerzaghiSolution({1, 1e-4, 9810, oedometer, 1e4, .4, .2e9}).initial_pressure(), 1e-9);
}

DeBoerColumn sand(std::function<double(double)> load) {
  return {5.5833e6, 8.375e6, .67, 2000, 1000, 1e-2, 9810, std::move(load)};
}

TEST(DeBoer, PrintedNumbers) {
  const DeBoerSolution step(sand([](double) { return 3e3; }));
  expect_printed(step.wave_speed(), 90.9432, 4);
  const double rows[][3] = {{.02, .098527, .0148197},
                            {.05, .1594398, .0590228},
                            {.1, .2271089, .1172967},
                            {.2, .3223114, .2055240},
                            {.5, .5106825, .3875295}};
  for (const auto& row : rows) {
    expect_printed(1e3 * step.displacement(0, row[0]), row[1], row[0] == .02 ? 6 : 7);
    expect_printed(1e3 * step.displacement(1, row[0]), row[2], 7);
  }
  const DeBoerSolution wave(sand([](double t) { return 3e3 * (1 - std::cos(75 * t)); }));
  const double swings[][2] = {{.02, .0459265}, {.05, .2323752}, {.1, .1587927}, {.2, .3208850}, {.5, .4766613}};
  for (const auto& row : swings) expect_printed(1e3 * wave.displacement(0, row[0]), row[1], 7);
}

TEST(DeBoer, SatisfiesItsEquationAndItsLoad) {
  const auto load = [](double t) { return 3e3 * (1 - std::cos(75 * t)); };
  const DeBoerColumn p = sand(load);
  const DeBoerSolution column(p);
  const double modulus = p.lame + 2 * p.shear_modulus, a = 1 / std::pow(column.wave_speed(), 2),
               b = p.water_unit_weight / (p.conductivity * modulus);
  double worst = 0;
  for (const double t : {.05, .12})
    for (const double z : {.3, 1.0}) {
      const auto in_time = [&](double s) { return column.displacement(z, s); };
      const auto in_depth = [&](double x) { return column.displacement(x, t); };
      worst = std::max(worst, relative_residual(a * derivative(in_time, t, .01, 2) + b * derivative(in_time, t, .01),
                                                derivative(in_depth, z, .2, 2)));
    }
  expect_residual(worst, 1e-6, "de_boer");
  // the surface carries the load: M u_z = -f
  const double slope =
      (-3 * column.displacement(0, .1) + 4 * column.displacement(1e-4, .1) - column.displacement(2e-4, .1)) / 2e-4;
  EXPECT_NEAR(-modulus * slope / load(.1), 1, 1e-4);
  EXPECT_EQ(column.displacement(10, .05), 0);  // 91 m/s
  EXPECT_THROW(DeBoerSolution(sand({})), std::invalid_argument);
}

/// A plane at 30 degrees through dry soil of 34 degrees: tan phi/tan beta; sin phi/tan beta; and F with
/// sin(atan(tan phi/F)) = tan beta.
TEST(InfiniteSlope, ThreeFactorsOfADrySlope) {
  const double beta = 30 * degree, phi = 34 * degree;
  const PlaneLoad load{std::cos(beta), std::sin(beta), 0};
  EXPECT_NEAR(limit_safety(load, {phi, 0, 0}), 1.168, 5e-4);
  EXPECT_NEAR(davis_safety(load, {phi, 0, 0}), 0.969, 5e-4);
  EXPECT_NEAR(reduced_safety(load, {phi, 0, 0}), std::tan(phi) / std::tan(std::asin(std::tan(beta))), 1e-12);
  for (const auto safety : {limit_safety, davis_safety, reduced_safety})
    EXPECT_NEAR(safety(load, {phi, phi, 0}), std::tan(phi) / std::tan(beta), 1e-12);
  // Soil that shrinks bears less than one that keeps its volume; cohesion alone is divided as it is.
  EXPECT_LT(davis_safety(load, {phi, -3 * degree, 0}), davis_safety(load, {phi, 0, 0}));
  EXPECT_NEAR(reduced_safety(load, {0, 0, 1}), 2, 1e-12);
}

TEST(InfiniteSlope, PressureTakesFrictionAndSuctionGivesIt) {
  const PlaneLoad load{10, 4, 6};
  const PlaneStrength soil{0.5, 0, 1};
  EXPECT_NEAR(limit_safety(load, soil), (1 + 4 * std::tan(0.5)) / 4, 1e-14);
  EXPECT_NEAR(limit_safety({10, 4, -6}, soil), (1 + 16 * std::tan(0.5)) / 4, 1e-14);
  EXPECT_NEAR(davis_safety(load, soil), (std::cos(0.5) + 4 * std::sin(0.5)) / 4, 1e-14);
  EXPECT_NEAR(limit_safety({10, 4, 20}, soil), 0.25, 1e-14);  // pushed apart: cohesion alone
  // Where Davis' factor is one, so is that of the reduced strength.
  const PlaneLoad critical{10, std::cos(0.5) + 4 * std::sin(0.5), 6};
  EXPECT_NEAR(reduced_safety(critical, soil), 1, 1e-12);
  EXPECT_THROW(limit_safety({1, 0, 0}, soil), std::invalid_argument);
}

}  // namespace
}  // namespace wetfront::verification::exact
