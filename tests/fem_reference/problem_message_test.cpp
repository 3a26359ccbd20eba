#include "fem_reference/problem_message.h"
#include "columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

RichardsProblem everything() {
  RichardsProblem problem = seed_column(4, 0.087, 3e-5, 500);
  problem.soils.push_back(
      {"table", TabulatedRetention{{-2, -1, 0}, {0.1, 0.2, 0.4}}, TabulatedConductivity{{-2, 0}, {0.1, 1}}, 1e-5});
  problem.soils.push_back(
      {"clay", BroadbridgeWhiteRetention{0.1, 0.4, 1.5, 0.3}, BroadbridgeWhiteConductivity{}, 1e-6});
  problem.soils.back().oedometer_modulus = 7e6;
  problem.soils.back().bishop = Soil::Bishop::effective_saturation;
  problem.conductivity_factor = {1, 2, 3, 4};
  problem.boundary = {RainSide{"top", {{0, 1}, {2e-5, 3e-5}}, {{0}, {1e-8}}, -80},
                      HeadSide{"base", 0.25, {{0, 10}, {1, 2}}, true},
                      FreeDrainageSide{"left"},
                      FluxSide{"right", {{0}, {-1e-6}}, -20},
                      WaterLevelSide{"bank", {{0, 5}, {0.1, 0.7}}, {{0}, {1e-6}}},
                      PeriodicSides{"a", "b"},
                      HeadSide{"kept", 0, {}, false, true}};
  problem.soils.back().anisotropy = {3, 1, 1, 0.5, 0, 0};
  problem.soils.back().porosity = 0.45;
  problem.soils.back().specific_storage = 1e-5;
  problem.adaptivity = Adaptivity{3, 2e-3};
  problem.gauges = {{"one", {1, 2, 3}}};
  problem.output_times = {100, 500};
  problem.degree = 2;
  problem.tolerance = 3e-5;
  problem.integrator = Integrator::backward_euler;
  return problem;
}

TEST(ProblemMessage, ArrivesWhole) {
  const RichardsProblem sent = everything();
  const RichardsProblem got = unpack(pack(sent));
  EXPECT_EQ(pack(got), pack(sent));
  EXPECT_EQ(got.mesh.nodes, sent.mesh.nodes);
  EXPECT_EQ(got.mesh.sides[1].name, "top");
  ASSERT_EQ(got.soils.size(), 3U);
  EXPECT_EQ(std::get<VanGenuchten>(got.soils[0].retention).n, std::get<VanGenuchten>(sent.soils[0].retention).n);
  EXPECT_EQ(std::get<TabulatedRetention>(got.soils[1].retention).content[1], 0.2);
  EXPECT_EQ(std::get<BroadbridgeWhiteRetention>(got.soils[2].retention).lambda, 0.3);
  EXPECT_EQ(got.soils[2].oedometer_modulus, 7e6);
  EXPECT_EQ(got.soils[2].bishop, Soil::Bishop::effective_saturation);
  EXPECT_EQ(std::get<RainSide>(got.boundary[0]).minimum_head, -80);
  EXPECT_TRUE(std::get<HeadSide>(got.boundary[1]).total);
  EXPECT_EQ(std::get<HeadSide>(got.boundary[1]).record.value[1], 2);
  EXPECT_EQ(std::get<FluxSide>(got.boundary[3]).inflow.intensity[0], -1e-6);
  EXPECT_EQ(std::get<WaterLevelSide>(got.boundary[4]).level.value[1], 0.7);
  EXPECT_EQ(std::get<PeriodicSides>(got.boundary[5]).partner, "b");
  EXPECT_EQ(got.gauges[0].position[2], 3);
  EXPECT_EQ(got.output_times, sent.output_times);
  EXPECT_EQ(got.degree, 2);
  EXPECT_EQ(got.integrator, Integrator::backward_euler);
  EXPECT_EQ(got.tolerance, 3e-5);
  EXPECT_EQ(got.end_time, sent.end_time);
  EXPECT_EQ(got.unit_weight, sent.unit_weight);
  EXPECT_EQ(got.gravity_direction, sent.gravity_direction);
  EXPECT_EQ(got.initial_head, sent.initial_head);
  EXPECT_EQ(got.conductivity_factor, sent.conductivity_factor);
  ASSERT_TRUE(got.adaptivity);
  EXPECT_EQ(got.adaptivity->levels, 3);
  EXPECT_EQ(got.adaptivity->threshold, 2e-3);
}

TEST(ProblemMessage, KeepsEveryEntryOfSoilsAndSides) {
  const RichardsProblem got = unpack(pack(everything()));
  EXPECT_EQ(std::get<TabulatedConductivity>(got.soils[1].conductivity).relative[0], 0.1);
  EXPECT_EQ(got.soils[2].name, "clay");
  EXPECT_EQ(got.soils[2].saturated_conductivity, 1e-6);
  EXPECT_EQ(got.soils[2].specific_storage, 1e-5);
  EXPECT_EQ(got.soils[2].porosity, 0.45);
  EXPECT_EQ(got.soils[2].anisotropy[3], 0.5);
  EXPECT_TRUE(std::holds_alternative<BroadbridgeWhiteConductivity>(got.soils[2].conductivity));
  const auto& rain = std::get<RainSide>(got.boundary[0]);
  EXPECT_EQ(rain.rain.start[1], 1);
  EXPECT_EQ(rain.rain.intensity[1], 3e-5);
  EXPECT_EQ(rain.evaporation.intensity[0], 1e-8);
  EXPECT_EQ(std::get<HeadSide>(got.boundary[1]).head, 0.25);
  EXPECT_EQ(std::get<FreeDrainageSide>(got.boundary[2]).side, "left");
  EXPECT_EQ(std::get<FluxSide>(got.boundary[3]).minimum_head, -20);
  EXPECT_EQ(std::get<WaterLevelSide>(got.boundary[4]).rain.intensity[0], 1e-6);
  EXPECT_FALSE(std::get<HeadSide>(got.boundary[1]).initial);
  EXPECT_TRUE(std::get<HeadSide>(got.boundary[6]).initial);
}

TEST(ProblemMessage, RefusesOneThatWasCut) {
  std::vector<char> message = pack(everything());
  message.pop_back();
  EXPECT_THROW(unpack(message), std::logic_error);
}

}  // namespace
}  // namespace wetfront::fem_reference
