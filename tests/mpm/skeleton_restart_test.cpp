// A cut run of sand that yields, falls and crosses cells goes on with the same bits, whatever acts on it.
#include "tests/mpm/continuation.h"
#include "tests/mpm/sheared_sand.h"

namespace wetfront::mpm {
namespace {

/// Sand as in the benchmarks, 100 points, for three cells' way of its top.
Problem<2> falling_sand() {
  Problem<2> problem = test::sheared_sand(100, 4, 1);
  problem.stages[0].end_time = 0.05;
  problem.output_times = {0.03, 0.05};
  return problem;
}

void put_on_contact(Problem<2>& problem) {
  problem.fixities = {{"left", {true, false, false}, "o"}};
  problem.skeleton_boundary = {FrictionalContact{"base", 0.4, "o"}};
}

/// Cuts a run at seven even places, the first step and the last one but one among them.
void expect_the_same_bits(const Problem<2>& problem, double least_crossings = 50) {
  Simulation<2> counted(problem);
  long steps = 0;
  for (; !counted.finished(); ++steps) counted.step();
  const State end = counted.state();
  EXPECT_GT(end.history.counters.at("points that changed cells"), least_crossings);
  for (const auto& row : end.history.motion) ASSERT_TRUE(std::isfinite(row.drift));
  test::expect_continuation(problem, std::max(1L, (steps - 2) / 6), 1);
}

using Change = void (*)(Problem<2>&);
struct Variant {
  const char* name;
  Change change;
};
struct CutSand : ::testing::TestWithParam<Variant> {};

TEST_P(CutSand, GoesOnWithTheSameBits) {
  Problem<2> problem = falling_sand();
  GetParam().change(problem);
  expect_the_same_bits(problem);
}

INSTANTIATE_TEST_SUITE_P(
    Skeleton, CutSand,
    ::testing::Values(Variant{"musl", [](Problem<2>&) {}},
                      Variant{"usl", [](Problem<2>& p) { p.skeleton.update = StressUpdate::usl; }},
                      Variant{"usf", [](Problem<2>& p) { p.skeleton.update = StressUpdate::usf; }},
                      Variant{"apic", [](Problem<2>& p) { p.skeleton.transfer = Transfer::apic; }},
                      Variant{"some_pic_and_damping",
                              [](Problem<2>& p) {
                                p.skeleton.pic = 0.02;
                                p.stages[0].local_damping = 0.05;
                              }},
                      Variant{"no_remedy", [](Problem<2>& p) { p.skeleton.locking = LockingRemedy::none; }},
                      Variant{"two_threads", [](Problem<2>& p) { p.threads = 2; }},
                      Variant{"crooked_cells",
                              [](Problem<2>& p) {
                                const test::Body body(100, 4);
                                p.mesh = test::crooked_box(body.across * 0.05, (body.cells + 2) * 0.05, body.across,
                                                           body.cells + 2);
                              }},
                      Variant{"contact", put_on_contact},
                      Variant{"contact_and_softening",
                              [](Problem<2>& p) {
                                put_on_contact(p);
                                SofteningMohrCoulomb law;
                                law.peak = {0.6, 500, 0.05, {}, "o"};
                                law.residual = {0.5, 0, 0, {}, "o"};
                                law.range = 0.1;
                                p.soils[0].law = law;
                              }},
                      Variant{"cam_clay",
                              [](Problem<2>& p) {
                                // Flies through the mesh, swinging.
                                p.gravity = {0, 0};
                                p.fixities.clear();
                                p.initial_velocity = [](const std::array<double, 2>& x) {
                                  return std::array<double, 2>{2.0 + 0.1 * x[1], 0.5};
                                };
                                p.soils[0].law = ModifiedCamClay{1.0, 0.1, 0.02, 0.67, 2e4, 1000, "o"};
                              }},
                      Variant{"moving_side",
                              [](Problem<2>& p) {
                                p.fixities = {{"base", {false, true, false}, "o"}};
                                p.skeleton_boundary = {MovingSide{"base", {0.5, {}, {}}, {}, "o"}};
                              }},
                      Variant{"absorbing_side",
                              [](Problem<2>& p) {
                                p.fixities = {{"base", {false, true, false}, "o"}};
                                p.skeleton_boundary = {AbsorbingSide{"base", "o"}};
                              }},
                      Variant{"loaded_side",
                              [](Problem<2>& p) {
                                // Soil comes to lie beside more of the loaded side as it runs out.
                                p.fixities = {{"base", {false, true, false}, "o"}};
                                p.skeleton_boundary = {Traction{"base", 0, {500, 0, 0}, {}, "o"}};
                              }},
                      Variant{"two_stages",
                              [](Problem<2>& p) {
                                p.stages[0].end_time = 0.02;
                                p.stages.push_back(p.stages[0]);
                                p.stages[1].end_time = 0.05;
                                p.stages[1].local_damping = 0.1;
                              }},
                      Variant{"two_soils",
                              [](Problem<2>& p) {
                                p.soils.push_back(p.soils[0]);
                                p.soils[1].name = "stiff";
                                p.soils[1].elastic->young *= 2;
                                const test::Body body(100, 4);
                                for (std::size_t c = 0; c < p.mesh.cell_count(); ++c)
                                  p.mesh.region[c] = static_cast<int>(c) % body.across < body.across / 2 ? 0 : 1;
                                p.mesh.region_names = {"sand", "stiff"};
                              }}),
    [](const auto& info) { return std::string(info.param.name); });

/// A run so long that rooms have overflowed and all was laid out anew many times; the body is a heap by then.
TEST(CutSand, GoesOnWithTheSameBitsAfterAllWasLaidOutAnew) {
  Problem<2> problem = falling_sand();
  put_on_contact(problem);
  problem.stages[0].end_time = 0.4;
  problem.output_times = {0.4};
  expect_the_same_bits(problem, 300);
}

}  // namespace
}  // namespace wetfront::mpm
