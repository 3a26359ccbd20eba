#include "verification/suites/mechanics/incline_block.h"

#include "verification/suites/mechanics/motion_setups.h"

#include <cmath>

namespace wetfront::verification {

namespace {

template <int dim>
meshes::Mesh mesh_of(const InclineBlock& block) {
  const double h = block.cell, length = 17, height = 1.5;
  const int along = static_cast<int>(std::lround(length / h)), over = static_cast<int>(std::lround(height / h));
  return dim == 2 ? rectangle_mesh(length, height, along, over)
                  : box_mesh(3, {length, 4 * h, height}, {along, 4, over});
}

/// Along the slope and out of the base.
template <int dim>
std::array<double, 2> on_slope(const InclineBlock& block, const std::array<double, dim>& x) {
  if (!block.turned_mesh) return {x[0], x[dim - 1]};
  const double c = std::cos(InclineBlock::slope), s = std::sin(InclineBlock::slope);
  return {x[0] * c - x[dim - 1] * s, x[0] * s + x[dim - 1] * c};
}

}  // namespace

template <int dim>
mpm::Problem<dim> block_problem(const InclineBlock& block) {
  constexpr std::size_t up = dim - 1;
  using B = InclineBlock;
  auto problem =
      dry_problem<dim>(mesh_of<dim>(block), dry_soil(B::density, B::young, B::poisson), evenly(block.end, 200));
  fill_only<dim>(problem, [&](const meshes::Point& at) {
    return at[0] > 0.5 && at[0] < 0.5 + block.length && at[up] < B::height;
  });
  if (block.turned_mesh)  // downhill is to the right
    for (auto& node : problem.mesh.nodes) {
      const double s = node[0], n = node[up];
      node[0] = s * std::cos(B::slope) + n * std::sin(B::slope);
      node[up] = -s * std::sin(B::slope) + n * std::cos(B::slope);
    }
  problem.gravity[0] = block.turned_mesh ? 0 : B::gravity * std::sin(B::slope);
  problem.gravity[up] = block.turned_mesh ? -B::gravity : -B::gravity * std::cos(B::slope);
  problem.initial_stress = mpm::InitialStress::k0;
  problem.skeleton_boundary.push_back(mpm::FrictionalContact{"base", block.friction, "suite"});
  if (dim == 3) add_rollers(problem, {"front", "back"});
  problem.skeleton.integration = mpm::StressIntegration::points;  // mixed: at mu = 0.5 it rocks more (6 %)
  problem.skeleton.pic = 0.01;  // the block comes to rest on its base; PIC leaves what moves as a whole alone
  if (!block.settled) return problem;
  mpm::Stage settling = problem.stages[0];
  settling.name = "settling";
  settling.motion = mpm::SkeletonMotion::quasi_static;
  settling.end_time = 1;
  settling.relaxation.most_iterations = 100000;  // of a mesh of a hundred cells; this body is eight long
  problem.stages.insert(problem.stages.begin(), settling);
  problem.stages[1].end_time += 1;
  for (double& time : problem.output_times) time += 1;
  problem.output_times.insert(problem.output_times.begin(), 1);
  return problem;
}

template <int dim>
std::vector<BlockState> block_path(const Motion<dim>& motion, const InclineBlock& block) {
  std::vector<BlockState> path;
  for (const auto& cloud : motion.clouds) {
    BlockState state{cloud.time, {}, {}};
    const auto n = static_cast<double>(cloud.size());  // points of one mass
    for (std::size_t p = 0; p < cloud.size(); ++p) {
      const auto x = on_slope<dim>(block, cloud.position[p]), v = on_slope<dim>(block, cloud.velocity[p]);
      for (std::size_t a = 0; a < 2; ++a) state.place[a] += x[a] / n, state.velocity[a] += v[a] / n;
    }
    path.push_back(state);
  }
  return path;
}

double mean_acceleration(const std::vector<BlockState>& path, std::size_t first) {
  double n = 0, t = 0, v = 0, tt = 0, tv = 0;
  for (std::size_t k = first; k < path.size(); ++k) {
    const double time = path[k].time, velocity = path[k].velocity[0];
    n += 1, t += time, v += velocity, tt += time * time, tv += time * velocity;
  }
  return (n * tv - t * v) / (n * tt - t * t);
}

template mpm::Problem<2> block_problem(const InclineBlock&);
template mpm::Problem<3> block_problem(const InclineBlock&);
template std::vector<BlockState> block_path(const Motion<2>&, const InclineBlock&);
template std::vector<BlockState> block_path(const Motion<3>&, const InclineBlock&);

}  // namespace wetfront::verification
