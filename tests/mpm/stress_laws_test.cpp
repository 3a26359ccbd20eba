// Stress laws at a point: returns to the surface, lanes against single points, finite strain.
#include "mpm/laws/stress_laws.h"

#include <gtest/gtest.h>

#include <random>

namespace wetfront::mpm {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
const Elastic elastic{10e6, 0.3, "test"};

using Normal = std::normal_distribution<double>;

template <int dim>
SymmetricTensor<dim> random_stress(std::mt19937& random, double mean, double spread) {
  Normal normal(0, spread);
  SymmetricTensor<dim> stress;
  for (int k = 0; k < stress_components<dim>; ++k) stress[k] = normal(random) + (k < 3 ? mean : 0.0);
  return stress;
}

template <int dim>
StepGradient<dim> random_step(std::mt19937& random, double size) {
  Normal normal(0, size);
  StepGradient<dim> step;
  for (auto& row : step.plane)
    for (double& entry : row) entry = normal(random);
  return step;
}

double contraction(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Case {
  const char* name;
  MohrCoulomb spec;
};
const std::vector<Case> associated{{"phi 34", {34 * degree, 0, 34 * degree, {}, ""}},
                                   {"phi 30 c 5", {30 * degree, 5e3, 30 * degree, {}, ""}},
                                   {"Tresca", {0, 5e3, 0, {}, ""}},
                                   {"cut-off", {30 * degree, 5e3, 30 * degree, 2e3, ""}},
                                   {"no tension", {30 * degree, 5e3, 30 * degree, 0.0, ""}},
                                   {"Tresca without tension", {0, 5e3, 0, 0.0, ""}}};

/// f and the excess over the cut-off, relative to the stresses.
double excess(const MohrCoulomb& spec, const std::array<double, 3>& s) {
  const double f = s[0] - s[2] + (s[0] + s[2]) * std::sin(spec.friction) - 2 * spec.cohesion * std::cos(spec.friction);
  const double size = std::abs(s[0]) + std::abs(s[2]) + 1e3;
  return std::max(f, spec.tension_cut_off ? s[0] - *spec.tension_cut_off : f) / size;
}

// Hill's principle picks the one right stress of an associated law: (sigma - tau):d e_p >= 0 for every tau that the
// surface admits. Its corners (edges, apex, cut-off and where they meet) all bound some tau, so a return to a wrong one
// is seen.
TEST(MohrCoulombReturn, AnAssociatedReturnDissipatesMost) {
  std::mt19937 random(7);
  for (const auto& [name, spec] : associated) {
    const LinearElastic law(elastic);
    const MohrCoulombStrength<double> strength = strength_of(spec);
    const MohrCoulombReturn<double> surface(strength, law.lame(), law.shear_modulus());
    int returned = 0;
    for (int trial = 0; trial < 3000; ++trial) {
      SymmetricTensor<3> stress = random_stress<3>(random, -5e3, 15e3);
      const Principal<3, double> before(stress);
      if (excess(spec, before.values) <= 0) continue;
      ++returned;
      std::array<double, 3> end =
          has_cut_off(spec) ? surface.with_cut_off(before.values) : surface.without_cut_off(before.values);
      // Round-off of a handful of operations on stresses of this size.
      ASSERT_LE(excess(spec, end), 1e-14) << name;
      std::array<double, 3> plastic;
      const double drop = before.values[0] + before.values[1] + before.values[2] - end[0] - end[1] - end[2];
      for (int k = 0; k < 3; ++k)
        plastic[k] =
            (before.values[k] - end[k] - law.lame() / (3 * law.bulk_modulus()) * drop) / (2 * law.shear_modulus());
      for (int other = 0; other < 40; ++other) {
        std::array<double, 3> tau = Principal<3, double>(random_stress<3>(random, -5e3, 15e3)).values;
        if (excess(spec, tau) > 0) tau = has_cut_off(spec) ? surface.with_cut_off(tau) : surface.without_cut_off(tau);
        std::shuffle(tau.begin(), tau.end(), random);
        const std::array<double, 3> difference{end[0] - tau[0], end[1] - tau[1], end[2] - tau[2]};
        ASSERT_GE(contraction(difference, plastic), -1e-12 * 15e3 * std::abs(drop + 15e3) / elastic.young) << name;
      }
    }
    EXPECT_GT(returned, 500) << name;
  }
}

// On face and edges the flow of psi says d(volume) = sin psi (|e1| + |e2| + |e3|); the apex flows with more volume.
TEST(MohrCoulombReturn, TheFlowDilatesByItsAngle) {
  std::mt19937 random(3);
  const MohrCoulomb spec{34 * degree, 5e3, 10 * degree, {}, ""};
  const LinearElastic law(elastic);
  const MohrCoulombReturn<double> surface(strength_of(spec), law.lame(), law.shear_modulus());
  int edges = 0, faces = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto before = Principal<3, double>(random_stress<3>(random, -30e3, 20e3)).values;
    if (excess(spec, before) <= 0) continue;
    const auto end = surface.without_cut_off(before);
    if (end[0] > 0.999 * surface.apex()) continue;
    const double drop = before[0] + before[1] + before[2] - end[0] - end[1] - end[2];
    const double volume = drop / (3 * law.bulk_modulus());
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::abs((before[k] - end[k] - law.lame() * volume) / (2 * law.shear_modulus()));
    ASSERT_NEAR(volume, std::sin(spec.dilatancy) * sum, 1e-12 * sum + 1e-18);
    (end[0] == end[1] || end[1] == end[2] ? edges : faces) += 1;
  }
  EXPECT_GT(edges, 500);
  EXPECT_GT(faces, 500);
}

template <int dim>
void expect_on_surface(const MohrCoulomb& spec) {
  std::mt19937 random(11);
  const MohrCoulombLaw law(elastic, spec);
  int yielded = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    LawPoint<MohrCoulombLaw, dim> point;
    point.stress = random_stress<dim>(random, -2e4, 1e4);
    law.advance(point, random_step<dim>(random, trial % 2 == 0 ? 1e-5 : 1e-2));
    const double above = excess(spec, Principal<dim, double>(point.stress).values);
    ASSERT_LE(above, 1e-10);
    if (above > -1e-10) ++yielded;
  }
  EXPECT_GT(yielded, 1000);
}

TEST(MohrCoulomb, EveryStressEndsOnTheSurfaceOrInside) {
  for (const auto& [name, spec] : associated) {
    SCOPED_TRACE(name);
    expect_on_surface<2>(spec);
    expect_on_surface<3>(spec);
  }
  expect_on_surface<2>({34 * degree, 1e3, 0, {}, ""});
  expect_on_surface<3>({34 * degree, 1e3, 0, 500.0, ""});
}

/// Four points each, over a few steps: the same numbers whether they go one by one or abreast.
template <int dim, class Law>
void expect_lanes_agree(const Law& law, double tolerance) {
  std::mt19937 random(5);
  double worst = 0;
  for (int trial = 0; trial < 200; ++trial) {
    LawPoint<Law, dim, Lanes> abreast;
    std::array<LawPoint<Law, dim>, lane_count> single;
    law.begin(abreast);
    for (int lane = 0; lane < lane_count; ++lane) {
      law.begin(single[lane]);
      single[lane].stress = random_stress<dim>(random, -3e4, 3e3);
      single[lane].suction = 1e4 * lane;
      abreast.suction[lane] = 1e4 * lane;
      for (int k = 0; k < stress_components<dim>; ++k) abreast.stress[k][lane] = single[lane].stress[k];
    }
    for (int turn = 0; turn < 10; ++turn) {
      StepGradient<dim, Lanes> steps;
      for (int lane = 0; lane < lane_count; ++lane) {
        const StepGradient<dim> step = random_step<dim>(random, 1e-3);
        law.advance(single[lane], step);
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b) steps.plane[a][b][lane] = step.plane[a][b];
      }
      law.advance(abreast, steps);
    }
    for (int lane = 0; lane < lane_count; ++lane) {
      const double size = 1e3 + std::abs(trace<dim>(single[lane].stress));
      for (int k = 0; k < stress_components<dim>; ++k) {
        const double difference = std::abs(double(abreast.stress[k][lane]) - single[lane].stress[k]) / size;
        ASSERT_TRUE(std::isfinite(difference));
        worst = std::max(worst, difference);
      }
      for (int m = 0; m < Law::template memory_size<dim>; ++m)
        ASSERT_NEAR(abreast.memory[m][lane], single[lane].memory[m], 1e-9 * std::abs(single[lane].memory[m]));
    }
  }
  EXPECT_LE(worst, tolerance);
}

/// Functions of the library (sine, logarithm) differ in the last bits between one number and four; iterations end
/// within their tolerance.
void expect_lanes_agree(const Soil& soil, double tolerance) {
  with_stress_law(soil, [&](const auto& law) {
    expect_lanes_agree<2>(law, tolerance);
    expect_lanes_agree<3>(law, tolerance);
  });
}

TEST(StressLaws, LanesGiveWhatSinglePointsGive) {
  Soil soil{};
  soil.elastic = elastic;
  expect_lanes_agree(soil, 0);
  soil.law = MohrCoulomb{34 * degree, 1e3, 10 * degree, {}, ""};
  expect_lanes_agree(soil, 1e-13);
  soil.law = SofteningMohrCoulomb{{34 * degree, 5e3, 10 * degree, 1e3, ""}, {25 * degree, 0, 0, {}, ""}, 0.02};
  expect_lanes_agree(soil, 1e-10);
  soil.law = SuctionMohrCoulomb{{34 * degree, 1e3, 0, {}, ""}, 5e3, 1, 0.1};
  expect_lanes_agree(soil, 1e-12);
  soil.law = ModifiedCamClay{1.2, 0.2, 0.02, 0.9, 5e4, 1000, ""};
  expect_lanes_agree(soil, 1e-12);
  soil.law = NeoHookean{};
  expect_lanes_agree(soil, 1e-12);
  soil.law = Hencky{};
  expect_lanes_agree(soil, 1e-12);
}

/// Uniaxial strain in steps, then a rigid turn: the stress along the fibre and the turned tensor.
template <class Law>
void expect_uniaxial(const Law& law, double stretch, double along, double across) {
  LawPoint<Law, 3> point;
  law.begin(point);
  const int steps = 7;
  for (int k = 0; k < steps; ++k) {
    StepGradient<3> step;
    step.plane[0][0] = std::pow(stretch, 1.0 / steps) - 1;
    law.advance(point, step);
  }
  EXPECT_NEAR(point.stress[0], along, 1e-9 * std::abs(along));
  EXPECT_NEAR(point.stress[1], across, 1e-9 * std::abs(along));
  StepGradient<3> quarter;  // x to y: a turn as one step, which a finite-strain law takes exactly
  quarter.plane = {{{-1, -1, 0}, {1, -1, 0}, {0, 0, 0}}};
  law.advance(point, quarter);
  EXPECT_NEAR(point.stress[1], along, 1e-9 * std::abs(along));
  EXPECT_NEAR(point.stress[0], across, 1e-9 * std::abs(along));
  EXPECT_NEAR(point.stress[3], 0, 1e-9 * std::abs(along));
}

TEST(FiniteStrain, UniaxialStretchHasItsClosedForm) {
  const LinearElastic e(elastic);
  for (double l : {0.5, 0.9, 1.3, 2.0}) {
    const double log = std::log(l);
    expect_uniaxial(NeoHookeanLaw(elastic), l, (e.lame() * log + e.shear_modulus() * (l * l - 1)) / l,
                    e.lame() * log / l);
    expect_uniaxial(HenckyLaw(elastic), l, e.constrained_modulus() * log / l, e.lame() * log / l);
  }
}

// The wave speed of a law is its stiffness: along the axis of uniaxial strain d(P)/d(F) l^2/J is the spatial modulus.
template <class Law>
void expect_modulus(const Law& law, double stretch) {
  const auto along = [&law](double l) {
    LawPoint<Law, 3> point;
    law.begin(point);
    StepGradient<3> step;
    step.plane[0][0] = l - 1;
    law.advance(point, step);
    return point;
  };
  const double small = 1e-6;
  const double stiffness =
      (along(stretch + small).stress[0] - along(stretch - small).stress[0]) / (2 * small) * stretch;
  const double modulus = law.constrained_modulus(along(stretch));
  // Never less than the stiffness, or a step would be too long; where it bounds, by the other principal stretches.
  EXPECT_GE(modulus, stiffness * (1 - 1e-6));
  EXPECT_LE(modulus, stiffness * 2);
}
TEST(FiniteStrain, TheModulusForTheStepIsNotLessThanTheStiffness) {
  for (double l : {0.6, 0.9, 1.0, 1.2}) {
    expect_modulus(NeoHookeanLaw(elastic), l);
    expect_modulus(HenckyLaw(elastic), l);
  }
}

TEST(Principal, ThreeDimensionsGiveTheTensorBack) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    SymmetricTensor<3> tensor = random_stress<3>(random, -1e4, trial % 3 == 0 ? 1e-6 : 1e4);
    if (trial % 5 == 0) tensor[3] = tensor[4] = tensor[5] = 0;
    if (trial % 7 == 0) tensor[1] = tensor[0];
    const Principal<3, double> principal(tensor);
    EXPECT_GE(principal.values[0], principal.values[1]);
    EXPECT_GE(principal.values[1], principal.values[2]);
    const auto back = principal.tensor();
    for (int k = 0; k < 6; ++k) ASSERT_NEAR(back[k], tensor[k], 1e-10);
  }
}

TEST(StressLaws, ASoilWithoutElasticConstantsIsRefused) {
  const Soil soil{};
  EXPECT_THROW(with_stress_law(soil, [](const auto&) {}), CannotPlan);
}

}  // namespace
}  // namespace wetfront::mpm
