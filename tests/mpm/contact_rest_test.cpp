// Bodies that rest, slide and bounce on a rigid base: wide ones too, and over seconds.
#include "mpm/simulation.h"
#include "tests/mpm/plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wetfront::mpm {
namespace {

constexpr double degree = 3.14159265358979323846 / 180, gravity = 9.81, cell = 0.25, block_length = 2;

/// A block 2 m long and 1 m high (in three dimensions as deep as a cell), elastic as soft soil, on a base that slopes.
struct Block {
  double friction, slope;
  bool turned_base = false;  ///< the mesh is turned and gravity acts down; else gravity is turned
  bool settled = true;       ///< begins in equilibrium; else with a stress at rest that knows nothing of the slope
  double seconds = 2;
  double above = 0;  ///< cells between it and the base
};

/// Along the slope and out of the base.
template <int dim>
std::array<double, 2> on_slope(const Block& b, const std::array<double, dim>& x) {
  const double turn = b.turned_base ? b.slope : 0, along = x[0], up = x[dim - 1];
  return {along * std::cos(turn) - up * std::sin(turn), along * std::sin(turn) + up * std::cos(turn)};
}

/// A plane mesh one cell deep: its second axis becomes the third.
meshes::Mesh extruded(const meshes::Mesh& plane, double depth) {
  meshes::Mesh mesh;
  mesh.dim = 3;
  const int n = static_cast<int>(plane.nodes.size());
  for (const double y : {0.0, depth})
    for (const auto& node : plane.nodes) mesh.nodes.push_back({node[0], y, node[1]});
  mesh.sides = {{"base", {}}, {"front", {}}, {"back", {}}};
  for (std::size_t c = 0; c < plane.cell_count(); ++c) {
    const int* q = &plane.cells[4 * c];
    for (int k : {q[0], q[1], q[1] + n, q[0] + n, q[3], q[2], q[2] + n, q[3] + n}) mesh.cells.push_back(k);
    for (int k = 0; k < 4; ++k) {
      mesh.sides[1].faces.push_back(q[k]);
      mesh.sides[2].faces.push_back(q[k] + n);
    }
  }
  const auto& edges = plane.sides.at(0).faces;  // the base
  for (std::size_t e = 0; e < edges.size(); e += 2)
    for (int k : {edges[e], edges[e + 1], edges[e + 1] + n, edges[e] + n}) mesh.sides[0].faces.push_back(k);
  mesh.region.assign(plane.cell_count(), 0);
  mesh.region_names = {"soil"};
  return mesh;
}

template <int dim>
meshes::Mesh block_mesh(const Block& b) {
  const double turn = b.turned_base ? b.slope : 0;
  const auto place = [turn](double along, double up) {
    return std::array{along * std::cos(turn) + up * std::sin(turn), -along * std::sin(turn) + up * std::cos(turn)};
  };
  const double length = 10, height = 2;
  const int nx = static_cast<int>(length / cell), ny = static_cast<int>(height / cell);
  meshes::Mesh plane = test::plane(nx, ny, [&](double u, double v) {
    const auto x = place(u * length, v * height);
    return meshes::Point{x[0], x[1], 0};
  });
  if constexpr (dim == 2) return plane;
  return extruded(plane, cell);
}

template <int dim>
Problem<dim> block(const Block& b) {
  Problem<dim> problem;
  problem.mesh = block_mesh<dim>(b);
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const auto centre = problem.mesh.cell_centre(c);
    std::array<double, dim> at{centre[0]};
    at[dim - 1] = centre[dim - 1];
    const auto [along, up] = on_slope<dim>(b, at);
    const double low = b.above * cell;
    problem.empty_cells.push_back(along > 0.5 && along < 0.5 + block_length && up > low && up < low + 1 ? 0 : 1);
  }
  problem.gravity[0] = b.turned_base ? 0 : gravity * std::sin(b.slope);
  problem.gravity[dim - 1] = b.turned_base ? -gravity : -gravity * std::cos(b.slope);
  problem.gravity_origin = "test:gravity";
  Soil soil;
  soil.name = "soil";
  soil.porosity = 0.5;
  soil.grain_density = 4000;
  soil.elastic = Elastic{5e6, 0.2, "test:elastic"};
  soil.origin = "test:soil";
  problem.soils = {soil};
  problem.points_per_cell = 1 << dim;
  problem.initial_stress = InitialStress::k0;
  problem.skeleton_boundary = {FrictionalContact{"base", b.friction, "test:base"}};
  if (dim == 3) problem.fixities = {{"front", {false, true, false}, "o"}, {"back", {false, true, false}, "o"}};
  Stage stage;
  stage.name = "motion";
  stage.origin = "test:stage";
  if (b.settled) {
    Stage settling = stage;
    settling.motion = SkeletonMotion::quasi_static;
    settling.end_time = 1;
    settling.relaxation.most_iterations = 100000;  // of a mesh of a hundred cells; this block is eight long
    problem.stages = {settling};
    problem.output_times = {1};
  }
  stage.end_time = b.seconds + (b.settled ? 1 : 0);
  problem.stages.push_back(stage);
  problem.output_times.push_back(stage.end_time);
  return problem;
}

/// Means over the points, along the slope and out of the base; and the lowest point.
struct Posture {
  std::array<double, 2> place{}, velocity{};
  double lowest = std::numeric_limits<double>::max();
};
template <int dim>
Posture posture(const Block& b, const State& state) {
  const auto &x = state.fields.at("point.position"), &v = state.fields.at("point.velocity");
  const std::size_t n = x.size() / dim;
  Posture out;
  for (std::size_t p = 0; p < n; ++p) {
    std::array<double, dim> place, velocity;
    for (std::size_t a = 0; a < dim; ++a) place[a] = x[a * n + p], velocity[a] = v[a * n + p];
    const auto at = on_slope<dim>(b, place), moves = on_slope<dim>(b, velocity);
    for (std::size_t a = 0; a < 2; ++a) {
      out.place[a] += at[a] / static_cast<double>(n);
      out.velocity[a] += moves[a] / static_cast<double>(n);
    }
    out.lowest = std::min(out.lowest, at[1]);
  }
  return out;
}
template <int dim>
void run_until(Simulation<dim>& simulation, double time) {
  while (!simulation.finished() && simulation.time() < time - 1e-9) simulation.step();
}

/// Farthest that the block, once settled, goes from its place.
template <int dim>
double wandering(const Block& b) {
  Simulation<dim> simulation(block<dim>(b));
  run_until(simulation, 1);
  const Posture start = posture<dim>(b, simulation.state());
  double farthest = 0;
  for (int k = 1; k <= 20; ++k) {
    run_until(simulation, 1 + k * b.seconds / 20);
    const Posture now = posture<dim>(b, simulation.state());
    farthest = std::max(farthest, std::hypot(now.place[0] - start.place[0], now.place[1] - start.place[1]));
  }
  return farthest;
}
// tan 30 = 0.577. Free fall along the slope would be 10 m. What is left of the relaxation (2e-4 of the forces) swings:
// measured 1e-5 of the length; a thousandth is what the issue allows.
TEST(ContactAtRest, AWideBlockStaysWhereFrictionHoldsIt) {
  EXPECT_LT(wandering<2>({0.6, 30 * degree}), 1e-3 * block_length);
  EXPECT_LT(wandering<2>({0.6, 30 * degree, true}), 1e-3 * block_length);
  EXPECT_LT(wandering<2>({0.3, 0}), 1e-3 * block_length);
}
TEST(ContactAtRest, AWideBlockStaysInThreeDimensions) {
  EXPECT_LT(wandering<3>({.friction = 0.6, .slope = 30 * degree, .seconds = 1}), 1e-3 * block_length);
}

/// Mean acceleration along the slope, from the velocity at a quarter of the time on.
template <int dim>
double acceleration(const Block& b) {
  Simulation<dim> simulation(block<dim>(b));
  run_until(simulation, 0.25 * b.seconds);
  const double first = posture<dim>(b, simulation.state()).velocity[0], began = simulation.time();
  run_until(simulation, b.seconds);
  return (posture<dim>(b, simulation.state()).velocity[0] - first) / (simulation.time() - began);
}
TEST(ContactThatSlides, AWideBlockFollowsCoulomb) {
  const double slope = 30 * degree;
  for (const double mu : {0.0, 0.2}) {
    const double wanted = gravity * (std::sin(slope) - mu * std::cos(slope));
    for (const bool turned : {false, true}) {
      const Block b{.friction = mu, .slope = slope, .turned_base = turned, .settled = false, .seconds = 1.5};
      EXPECT_NEAR(acceleration<2>(b) / wanted, 1, 0.01) << mu << turned;  // the issue's
    }
    EXPECT_NEAR(acceleration<3>({.friction = mu, .slope = slope, .settled = false, .seconds = 0.7}) / wanted, 1, 0.01);
  }
}

// A block let go above its base falls freely until it is there, not until its first point is in a cell of the base.
TEST(ContactThatFalls, NothingIsFeltBeforeTheBaseIsReached) {
  const double fall = std::sqrt(2 * cell / gravity);
  const Block b{.friction = 0.3, .slope = 0, .settled = false, .seconds = 0.95 * fall, .above = 1};
  Problem<2> problem = block<2>(b);
  problem.initial_stress = InitialStress::none;
  Simulation<2> simulation(problem);
  const Posture start = posture<2>(b, simulation.state());
  run_until(simulation, b.seconds);
  const Posture end = posture<2>(b, simulation.state());
  EXPECT_NEAR(end.velocity[1], -gravity * b.seconds, 1e-12);
  // Steps of an explicit scheme: half of one times the velocity.
  EXPECT_NEAR(end.place[1] - start.place[1], -0.5 * gravity * b.seconds * b.seconds, 5e-3);
}

// A node of the base that sticks has the velocity that closes its gap, and has it again when the points' velocities
// have been mapped back. Stopped dead in place of that, a block that lands makes 2.9 % of the energy it fell with; as
// it is .8 %, of points that are stopped a step after nodes.
TEST(ContactThatFalls, LandingOnARoughBaseMakesNoEnergy) {
  const Block b{.friction = 0.6, .slope = 0, .settled = false, .seconds = 1.2, .above = 1};
  Problem<2> problem = block<2>(b);
  problem.initial_stress = InitialStress::none;
  Simulation<2> simulation(problem);
  run_until(simulation, b.seconds);
  const meshes::FieldHistory history = simulation.take_history();
  double made = 0, fell = 0;
  for (const meshes::MotionRow& row : history.motion) {
    made = std::max(made, row.drift);
    fell = std::max(fell, history.motion.front().potential - row.potential);
  }
  EXPECT_GT(fell, 0.9 * 2 * 2000 * gravity * cell);
  EXPECT_LT(made, 0.015 * fell);
}

// Shaken, but too rough to slide (mu = .7, tan 30 = .577): nodes that stick stay put, so the block rocks where it
// stands. With what is mapped back at these nodes it creeps twice as far and stands on its noise, .0014 m higher in the
// mean.
TEST(ContactAtRest, ARockingBlockKeepsItsPlace) {
  const Block b{.friction = 0.7, .slope = 30 * degree, .settled = false, .seconds = 1.5};
  Simulation<2> simulation(block<2>(b));
  const Posture start = posture<2>(b, simulation.state());
  double mean = 0;
  for (int k = 1; k <= 20; ++k) {
    run_until(simulation, k * b.seconds / 20);
    if (k > 10) mean += (posture<2>(b, simulation.state()).place[1] - start.place[1]) / 10;
  }
  EXPECT_LT(std::abs(mean), 5e-4);
  EXPECT_LT(std::abs(posture<2>(b, simulation.state()).place[0] - start.place[0]), 5e-3);
}

// Shaken (it begins with a stress that does not know the slope), the block slides, rocks and hops. It comes down each
// time: without the gap it was .1 m, nearly half a cell, higher after 1.5 s, and climbed on.
TEST(ContactThatFalls, ABlockThatHopsDoesNotClimb) {
  const Block b{.friction = 0.5, .slope = 30 * degree, .settled = false, .seconds = 2};
  Simulation<2> simulation(block<2>(b));
  const Posture start = posture<2>(b, simulation.state());
  double mean = 0;
  for (int k = 1; k <= 40; ++k) {
    run_until(simulation, k * b.seconds / 40);
    const Posture now = posture<2>(b, simulation.state());
    if (k > 20) mean += (now.place[1] - start.place[1]) / 20;
  }
  // Points as seeded begin .04 cells nearer than the half spacing at which they are held; the rest are hops.
  EXPECT_LT(mean, 0.1 * cell);
}

}  // namespace
}  // namespace wetfront::mpm
