// Laws in the material driver against closed forms (benchmarks.md section 6).
#include "mpm/laws/material_driver.h"
#include "mpm/laws/stress_laws.h"

#include <gtest/gtest.h>

namespace wetfront::mpm {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

Soil soil_with(const SkeletonLaw& law) {
  Soil soil{};
  soil.elastic = Elastic{10e6, 0.3, "test"};
  soil.law = law;
  return soil;
}
Soil frictional(double phi, double c, double psi = 0) {
  return soil_with(MohrCoulomb{phi * degree, c, psi * degree, {}, ""});
}

PathStart<3> isotropic(double pressure) {
  return {{-pressure, -pressure, -pressure, 0, 0, 0}};
}
/// Axial strain along z under a constant cell pressure.
PathLeg<3> triaxial(double axial_strain, double cell_pressure, int steps) {
  PathLeg<3> leg;
  leg.strain[2] = axial_strain;
  leg.stress[0] = leg.stress[1] = -cell_pressure;
  leg.steps = steps;
  return leg;
}

// "Mohr-Coulomb paths to 1e-10": the issue.
constexpr double exact = 1e-10;

TEST(MohrCoulombPaths, TriaxialCompressionReachesTheFlowNumber) {
  for (double psi : {0.0, 15.0, 34.0}) {
    const auto path = drive<3>(frictional(34, 0, psi), isotropic(100e3), {triaxial(-0.06, 100e3, 60)});
    EXPECT_NEAR(-path.back().stress[2] / 353713.204, 1, 1e-9);  // the printed digits
    const double flow_number = (1 + std::sin(34 * degree)) / (1 - std::sin(34 * degree));
    EXPECT_NEAR(-path.back().stress[2] / (flow_number * 100e3), 1, exact);
    const auto [p, q] = pressure_and_shear(path.back().stress);
    EXPECT_NEAR(q / p, 1.374610, 5e-7);
    EXPECT_NEAR(q / p / (6 * std::sin(34 * degree) / (3 - std::sin(34 * degree))), 1, exact);
    for (const auto& state : path) EXPECT_NEAR(state.stress[0], -100e3, 1e-6);
  }
  const auto cohesive = drive<3>(frictional(30, 5e3), isotropic(100e3), {triaxial(-0.06, 100e3, 60)});
  EXPECT_NEAR(-cohesive.back().stress[2] / (300e3 + 10e3 * std::sqrt(3)), 1, exact);
  EXPECT_NEAR(-cohesive.back().stress[2] / 317320.508, 1, 1e-9);
}

TEST(MohrCoulombPaths, TriaxialExtensionReachesItsRatio) {
  const auto path = drive<3>(frictional(34, 0), isotropic(100e3), {triaxial(0.06, 100e3, 60)});
  const auto [p, q] = pressure_and_shear(path.back().stress);
  EXPECT_NEAR(q / p, 0.942674, 5e-7);
  EXPECT_NEAR(q / p / (6 * std::sin(34 * degree) / (3 + std::sin(34 * degree))), 1, exact);
}

TEST(MohrCoulombPaths, YieldBeginsAtItsStrainAndTheLineBeforeIsElastic) {
  const double yield = 0.02537132;  // E = 10 MPa
  const Soil soil = frictional(34, 0);
  const auto before = drive<3>(soil, isotropic(100e3), {triaxial(-yield * (1 - 1e-6), 100e3, 1)}).back();
  EXPECT_NEAR(-before.stress[2] / (100e3 + 10e6 * yield * (1 - 1e-6)), 1, exact);
  EXPECT_NEAR(before.strain[0] / (0.3 * yield * (1 - 1e-6)), 1, 1e-8);
  const auto after = drive<3>(soil, isotropic(100e3), {triaxial(-yield * (1 + 1e-6), 100e3, 1)}).back();
  EXPECT_NEAR(-after.stress[2] / 353713.204, 1, 1e-9);
}

TEST(MohrCoulombPaths, DilatancyGivesItsVolumeAfterYield) {
  const auto path = drive<3>(frictional(34, 0, 10), isotropic(100e3), {triaxial(-0.06, 100e3, 60)});
  const auto &a = path[path.size() - 11], &b = path.back();
  const double axial = b.strain[2] - a.strain[2], volume = trace<3>(b.strain) - trace<3>(a.strain);
  // d(volume)/d(axial) = 1 - (1 + sin psi)/(1 - sin psi) of triaxial compression (Bolton 1986).
  EXPECT_NEAR(volume / axial, 1 - (1 + std::sin(10 * degree)) / (1 - std::sin(10 * degree)), 1e-8);
}

TEST(MohrCoulombPaths, SimpleShearIsCoaxialWithoutDilatancy) {
  PathLeg<2> leg;
  leg.stress[1] = -100e3;
  leg.strain[3] = 0.2;
  leg.steps = 400;
  const auto path = drive<2>(frictional(34, 0), {{-100e3, -100e3, -100e3, 0}}, {leg});
  const double ratio = path.back().stress[3] / 100e3;
  EXPECT_NEAR(ratio, 0.559193, 5e-7);  // sin phi, not tan phi = 0.674509
  EXPECT_NEAR(ratio / std::sin(34 * degree), 1, exact);
}

TEST(MohrCoulombPaths, TheOedometerIsElasticAndKeepsItsRatio) {
  PathLeg<3> leg;
  leg.strain[2] = -0.01;
  const auto end = drive<3>(frictional(34, 0), {}, {leg}).back();
  const double modulus = 10e6 * 0.7 / (1.3 * 0.4);
  EXPECT_NEAR(end.stress[2] / (-0.01 * modulus), 1, exact);
  EXPECT_NEAR(end.stress[0] / end.stress[2], 0.3 / 0.7, exact);
}

TEST(MohrCoulombPaths, ATensileTestStopsAtTheCutOff) {
  const Soil soil = soil_with(MohrCoulomb{30 * degree, 5e3, 0, 2e3, ""});
  PathLeg<3> one_way, all_ways;
  one_way.strain = {0, 0, 0.01, 0, 0, 0};
  all_ways.strain = {0.01, 0.01, 0.01, 0, 0, 0};
  const auto face = drive<3>(soil, {}, {one_way}).back();  // across, what the elastic strain leaves: nu/(1-nu)
  EXPECT_NEAR(face.stress[2] / 2e3, 1, exact);
  EXPECT_NEAR(face.stress[0] / (2e3 * 0.3 / 0.7), 1, exact);
  const auto apex = drive<3>(soil, {}, {all_ways}).back();
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(apex.stress[k] / 2e3, 1, exact);
}

TEST(MohrCoulombPaths, AStressThatCannotBeReachedIsAnError) {
  PathLeg<3> beyond;
  beyond.stress = {-100e3, -100e3, -400e3};
  EXPECT_THROW(drive<3>(frictional(34, 0), isotropic(100e3), {beyond}), std::runtime_error);
}

TEST(SofteningPaths, TheStressFollowsTheStrengthOfItsStrain) {
  const SofteningMohrCoulomb spec{{38 * degree, 6e3, 8 * degree, {}, ""}, {30 * degree, 1e3, 0, {}, ""}, 0.05};
  const auto path = drive<3>(soil_with(spec), isotropic(100e3), {triaxial(-0.15, 100e3, 300)});
  int softening = 0;
  double last = 0;
  for (const auto& state : path) {
    const double gamma = state.memory[0], share = std::min(gamma / 0.05, 1.0);
    EXPECT_GE(gamma, last);
    last = gamma;
    if (gamma == 0) continue;
    const double phi = (38 - 8 * share) * degree, c = 6e3 - 5e3 * share;
    const double n = (1 + std::sin(phi)) / (1 - std::sin(phi));
    EXPECT_NEAR(-state.stress[2] / (n * 100e3 + 2 * c * std::sqrt(n)), 1, exact);
    if (share < 1) ++softening;
  }
  EXPECT_GT(softening, 50);
  EXPECT_GT(last, 0.05);
  // With the stress at rest all strain is plastic: the deviator of (axial, radial, radial) strain increments.
  const auto &a = path[path.size() - 2], &b = path.back();
  const double axial = b.strain[2] - a.strain[2], radial = b.strain[0] - a.strain[0];
  EXPECT_NEAR((b.memory[0] - a.memory[0]) / (2.0 / 3 * std::abs(axial - radial)), 1, 1e-6);
}

/// A contractive soil: sheared grains come closer until the plastic shear strain is that of the softening range.
TEST(SofteningPaths, ALooseSoilContractsUntilTheEndOfItsRange) {
  const MohrCoulomb loose{34 * degree, 0, -3 * degree, {}, ""}, critical{34 * degree, 0, 0, {}, ""};
  const double range = 0.3;
  const auto path = drive<3>(soil_with(SofteningMohrCoulomb{loose, critical, range}), isotropic(100e3),
                             {triaxial(-0.6, 100e3, 2000)});
  const auto volume = [](const PathState<3>& s) { return s.strain[0] + s.strain[1] + s.strain[2]; };
  // On the edge of triaxial compression the flow (1 + s, 1 + s, -2 (1 - s)), s = sin psi, has the volume 4 s and the
  // plastic shear 2 (1 - s/3); psi goes to zero in a straight line. The stress stands still, so all strain is plastic.
  const auto rate = [&](double gamma) {
    const double s = std::sin(-3 * degree * std::max(0.0, 1 - gamma / range));
    return 2 * s / (1 - s / 3);
  };
  std::size_t first = 0;
  while (path[first].memory[0] == 0) ++first;
  ++first;  // the step in which it began to yield is part elastic
  double expected = 0, at_range = 0;
  for (std::size_t k = first + 1; k < path.size(); ++k) {
    const double a = path[k - 1].memory[0], b = path[k].memory[0];
    expected += (b - a) * rate(b);  // backward Euler, as the law
    if (b < range) at_range = volume(path[k]);
  }
  EXPECT_GT(path.back().memory[0], 1.5 * range);
  EXPECT_LT(expected, -0.01);
  // Changes of the rate within a step (2000 steps) leave 1e-4 of it.
  EXPECT_NEAR((volume(path.back()) - volume(path[first])) / expected, 1, 1e-3);
  EXPECT_NEAR(volume(path.back()), at_range, 1e-5);
}

/// The same at constant volume, as under water without drainage: what cannot come closer lets its stress go, K times
/// the contraction that is hindered.
TEST(SofteningPaths, ALooseSoilLosesItsStressWhereItsVolumeIsKept) {
  PathLeg<3> shear;
  shear.strain = {0.05, 0.05, -0.1, 0, 0, 0};
  shear.steps = 1000;
  const double range = 0.3, bulk = 10e6 / (3 * (1 - 2 * 0.3));
  const MohrCoulomb loose{34 * degree, 0, -3 * degree, {}, ""}, critical{34 * degree, 0, 0, {}, ""};
  const auto path = drive<3>(soil_with(SofteningMohrCoulomb{loose, critical, range}), isotropic(100e3), {shear});
  double lost = 0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double gamma = path[k].memory[0], s = std::sin(-3 * degree * (1 - gamma / range));
    lost -= bulk * (gamma - path[k - 1].memory[0]) * 2 * s / (1 - s / 3);
  }
  EXPECT_GT(lost, 60e3);
  EXPECT_NEAR((100e3 - pressure_and_shear(path.back().stress).p) / lost, 1, 1e-6);
}

TEST(SuctionPaths, StrengthGrowsWithSuctionAndWettingTakesItBack) {
  const SuctionMohrCoulomb spec{{30 * degree, 2e3, 0, {}, ""}, 8e3, 3, 10 * degree};
  PathStart<3> dry = isotropic(50e3);
  dry.suction = 40e3;
  PathLeg<3> wet = triaxial(0, 50e3, 20);
  wet.suction = 0;
  const auto path = drive<3>(soil_with(spec), dry, {triaxial(-0.06, 50e3, 60), wet});
  const auto failure = [](double phi, double c) {
    const double n = (1 + std::sin(phi)) / (1 - std::sin(phi));
    return n * 50e3 + 2 * c * std::sqrt(n);
  };
  const double cohesion = 2e3 + 8e3 * (1 - std::exp(-3 * 0.4)), friction = (30 + 10 * 0.4) * degree;
  EXPECT_NEAR(-path[60].stress[2] / failure(friction, cohesion), 1, exact);
  EXPECT_NEAR(-path.back().stress[2] / failure(30 * degree, 2e3), 1, exact);
}

const ModifiedCamClay clay{1.2, 0.16, 0.03, 0.9, 100e3, 1000, ""};
const double Lambda = (0.16 - 0.03) / 0.16;

TEST(CamClayPaths, IsotropicCompressionFollowsBothLines) {
  PathLeg<3> squeeze, release;
  squeeze.strain = {-0.04, -0.04, -0.04, 0, 0, 0};
  release.strain = {0.01, 0.01, 0.01, 0, 0, 0};
  for (int steps : {5, 200}) {  // exact for any step, README of the law
    squeeze.steps = release.steps = steps;
    const auto path = drive<3>(soil_with(clay), isotropic(60e3), {squeeze, release});
    double consolidation = 100e3;
    for (const auto& state : path) {
      const double p = -state.stress[0], e = 1.9 * std::exp(trace<3>(state.strain)) - 1;
      consolidation = std::max(consolidation, p);
      EXPECT_NEAR(state.memory[1], e, 1e-12);
      EXPECT_NEAR(state.memory[0] / consolidation, 1, exact);
      const double line = 0.9 - 0.03 * std::log(p / 60e3) - 0.13 * std::log(consolidation / 100e3);
      EXPECT_NEAR(e, line, 1e-10);
    }
    EXPECT_GT(consolidation, 150e3);
  }
}

// No volume change: p_c = p (1 + eta^2/M^2) and kappa ln p + (lambda - kappa) ln p_c stays, so
// p/p_0 = (1 + eta^2/M^2)^-Lambda from a normally consolidated state, down to p_0 2^-Lambda.
TEST(CamClayPaths, AnUndrainedTriaxialTestFollowsItsStressPath) {
  PathLeg<3> leg;
  leg.strain = {0.15, 0.15, -0.3, 0, 0, 0};
  leg.steps = 600;
  const auto path = drive<3>(soil_with(clay), isotropic(100e3), {leg});
  for (const auto& state : path) {
    const auto [p, q] = pressure_and_shear(state.stress);
    const double eta = q / p / 1.2;
    EXPECT_NEAR(p / (100e3 * std::pow(1 + eta * eta, -Lambda)), 1, exact);
  }
  const auto [p, q] = pressure_and_shear(path.back().stress);
  EXPECT_NEAR(p / (100e3 * std::pow(2, -Lambda)), 1, 1e-5);  // approached with strain, not reached
  EXPECT_NEAR(q / p, 1.2, 1e-5);
}

TEST(CamClayPaths, ADrainedTestEndsInTheCriticalState) {
  for (double consolidation : {100e3, 800e3}) {  // from the wet side and, softening, from the dry side
    ModifiedCamClay spec = clay;
    spec.preconsolidation = consolidation;
    const auto path = drive<3>(soil_with(spec), isotropic(100e3), {triaxial(-0.8, 100e3, 1600)});
    double most = 0;
    for (const auto& state : path) {
      const auto [p, q] = pressure_and_shear(state.stress);
      most = std::max(most, q);
      // Volume of the elastic and of the plastic line together, at every state.
      const double line = 0.9 - 0.03 * std::log(p / 100e3) - 0.13 * std::log(state.memory[0] / consolidation);
      ASSERT_NEAR(state.memory[1], line, 1e-10);
    }
    const auto [p, q] = pressure_and_shear(path.back().stress);
    EXPECT_NEAR(q / (1.2 * 300e3 / (3 - 1.2)), 1, 1e-3);  // q = 3 (p - cell pressure) meets q = M p
    EXPECT_NEAR(2 * p / path.back().memory[0], 1, 5e-3);
    if (consolidation > 500e3) {
      EXPECT_GT(most, 1.3 * q);
    }
  }
}

// Steps four times as long: backward Euler's first-order error in the shear strain only.
TEST(CamClayPaths, LongStepsConvergeToShortOnes) {
  std::array<double, 3> q;
  for (int k = 0; k < 3; ++k)
    q[k] = pressure_and_shear(
               drive<3>(soil_with(clay), isotropic(100e3), {triaxial(-0.05, 100e3, 100 << (2 * k))}).back().stress)
               .q;
  EXPECT_NEAR(q[1] / q[2], 1, 2e-3);
  EXPECT_LT(std::abs(q[1] - q[2]), 0.4 * std::abs(q[0] - q[1]));
}

}  // namespace
}  // namespace wetfront::mpm
