// Numbers that physics does not allow are refused before anything runs, each with the entry's name.
#include "mpm/plan.h"
#include "tests/mpm/strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace wetfront::mpm {
namespace {

struct Spoilt {
  const char* name;
  std::function<void(Problem<2>&)> spoil;
  const char* complaint;
};

VanGenuchtenRetention& curve(Problem<2>& problem) {
  return std::get<VanGenuchtenRetention>(*problem.soils[0].retention);
}
RainSide& rain(Problem<2>& problem) {
  return std::get<RainSide>(problem.water_boundary[0]);
}

void expect_refused(Problem<2> problem, const Spoilt& spoilt) {
  ASSERT_NO_THROW(plan(problem));
  spoilt.spoil(problem);
  try {
    plan(problem);
    FAIL() << "accepted";
  } catch (const CannotPlan& refused) {
    EXPECT_THAT(refused.what(), ::testing::HasSubstr(spoilt.complaint));
  }
}

class CheckNumbers : public ::testing::TestWithParam<Spoilt> {};

TEST_P(CheckNumbers, RefusesAndSaysWhat) {
  expect_refused(test::seed_column(5, 0.087, 3e-5, 1), GetParam());
}

const Spoilt all[] = {
    {"Start", [](auto& p) { p.initial_pressure[3] = std::nan(""); }, "initial pressure at mesh node 3 is nan"},
    {"Porosity", [](auto& p) { p.soils[0].porosity = 1; }, "test:soil: porosity of soil 'sand' is 1"},
    {"Permeability", [](auto& p) { p.soils[0].intrinsic_permeability = 0; }, "intrinsic permeability"},
    {"Saturations", [](auto& p) { curve(p).s_min = 1.1; }, "s_max of soil 'sand'"},
    {"Lambda", [](auto& p) { curve(p).lambda = 1.2; }, "lambda of soil 'sand' is 1.2"},
    {"AirEntry", [](auto& p) { curve(p).air_entry = -1; }, "air entry of soil 'sand'"},
    {"NotANumberOfRain", [](auto& p) { rain(p).rain.intensity[0] = NAN; }, "test:rain: value 0 of the rain record"},
    {"NegativeRain", [](auto& p) { rain(p).rain.intensity[0] = -1e-9; }, "it has to be 0 or more"},
    {"RainBackwards",
     [](auto& p) {
       rain(p).rain = {{5, 3}, {0, 0}};
     },
     "time 1 of the rain record is 3"},
    {"RainShort",
     [](auto& p) {
       rain(p).rain = {{5, 6}, {0}};
     },
     "it has 2 times"},
    {"Water", [](auto& p) { p.water->bulk_modulus = -1; }, "bulk modulus of the water"},
    {"HeldPressure",
     [](auto& p) {
       p.water_boundary = {PressureSide{"base", INFINITY, "o"}};
     },
     "prescribed pressure"},
    {"Cell", [](auto& p) { p.mesh.nodes[4][1] = p.mesh.nodes[5][1] = -0.1; }, "corner of mesh cell"},
    {"End", [](auto& p) { p.stages[0].end_time = INFINITY; }, "end of stage 'infiltration' is inf"},
};
INSTANTIATE_TEST_SUITE_P(All, CheckNumbers, ::testing::ValuesIn(all),
                         [](const auto& info) { return std::string(info.param.name); });

/// A dry column that deforms.
Problem<2> deforming() {
  Problem<2> problem = test::seed_column(3, 0.087, 0, 1);
  problem.water.reset();
  problem.initial_pressure.clear();
  problem.water_boundary.clear();
  problem.stages[0].liquid.reset();
  problem.soils[0].elastic = Elastic{10e6, 0.3, "test:elastic"};
  problem.fixities = {{"base", {true, true, true}, ""}};
  return problem;
}
MohrCoulomb sand_strength() {
  return {0.6, 0, 0, {}, "test:law"};
}

class CheckSkeleton : public ::testing::TestWithParam<Spoilt> {};

TEST_P(CheckSkeleton, RefusesAndSaysWhat) {
  expect_refused(deforming(), GetParam());
}

const Spoilt skeletons[] = {
    {"Young", [](auto& p) { p.soils[0].elastic->young = 0; }, "test:elastic: Young's modulus of soil 'sand' is 0"},
    {"Poisson", [](auto& p) { p.soils[0].elastic->poisson = 0.5; }, "Poisson's ratio"},
    {"Friction",
     [](auto& p) {
       MohrCoulomb law = sand_strength();
       law.friction = 34;
       p.soils[0].law = law;
     },
     "test:law: friction angle of soil 'sand' is 34"},
    {"Dilatancy",
     [](auto& p) {
       MohrCoulomb law = sand_strength();
       law.dilatancy = 0.7;
       p.soils[0].law = law;
     },
     "work out of nothing"},
    {"NoStrength",
     [](auto& p) {
       MohrCoulomb law = sand_strength();
       law.friction = 0;
       p.soils[0].law = law;
     },
     "which has no friction"},
    {"Softening",
     [](auto& p) {
       p.soils[0].law = SofteningMohrCoulomb{sand_strength(), sand_strength(), 0};
     },
     "softening range"},
    {"CamClay", [](auto& p) { p.soils[0].law = ModifiedCamClay{1.2, 0.02, 0.1, 0.8, 1e5, 1e3, "o"}; },
     "compression of soil 'sand' is 0.02"},
    {"BaseFriction",
     [](auto& p) {
       p.skeleton_boundary = {FrictionalContact{"base", -0.1, "test:base"}};
     },
     "test:base: friction of the base is -0.1"},
    {"Pic", [](auto& p) { p.skeleton.pic = 1.1; }, "share of PIC"},
    {"Threads", [](auto& p) { p.threads = 0; }, "number of threads"},
    {"RelaxationDamping", [](auto& p) { p.stages[0].relaxation.damping = 1; }, "relaxation damping"},
    {"RigidWithStrength",
     [](auto& p) {
       p.soils[0].elastic.reset();
       p.soils[0].law = sand_strength();
     },
     "strength but no stiffness"},
    {"RigidWithLoad",
     [](auto& p) {
       p.soils[0].elastic.reset();
       p.skeleton_boundary = {Traction{"top", 1e3, {}, {}, "test:load"}};
     },
     "test:load: a load, contact or motion on a side of a rigid skeleton"},
    {"RigidWithStress",
     [](auto& p) {
       p.soils[0].elastic.reset();
       p.initial_stress = InitialStress::k0;
     },
     "rigid skeleton"},
    {"VelocityBeforeEquilibrium",
     [](auto& p) {
       p.stages[0].motion = SkeletonMotion::quasi_static;
       p.initial_velocity = [](const auto&) { return std::array{1.0, 0.0}; };
     },
     "an initial velocity is given, but the first stage is quasi-static"},
};
INSTANTIATE_TEST_SUITE_P(All, CheckSkeleton, ::testing::ValuesIn(skeletons),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(CheckNumbers, LetsIncompressibleWaterBe) {
  Problem<2> problem = test::seed_column(5, 0.087, 3e-5, 1);
  problem.water->bulk_modulus = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(plan(problem));
}

}  // namespace
}  // namespace wetfront::mpm
