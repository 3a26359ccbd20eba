#include "verification/suites/mechanics/motion.h"

#include "mpm/simulation.h"

#include <algorithm>
#include <limits>

namespace wetfront::verification {
namespace {

/// A carried column of points, component after component; empty where the plan does not have it.
template <std::size_t components>
std::vector<std::array<double, components>> tuples(const mpm::State& state, const std::string& name) {
  const auto found = state.fields.find("point." + name);
  if (found == state.fields.end()) return {};
  const std::size_t count = found->second.size() / components;
  std::vector<std::array<double, components>> out(count);
  for (std::size_t k = 0; k < components; ++k)
    for (std::size_t p = 0; p < count; ++p) out[p][k] = found->second[k * count + p];
  return out;
}

std::vector<double> scalars(const mpm::State& state, const std::string& name) {
  const auto found = state.fields.find("point." + name);
  return found == state.fields.end() ? std::vector<double>{} : found->second;
}

template <int dim>
Cloud<dim> cloud_of(const mpm::State& state) {
  Cloud<dim> cloud;
  cloud.time = state.time;
  cloud.position = tuples<dim>(state, "position");
  cloud.velocity = tuples<dim>(state, "velocity");
  cloud.origin = tuples<dim>(state, "initial position");
  cloud.stress = tuples<2 * dim>(state, "stress");
  cloud.volume = scalars(state, "volume");
  cloud.mass = scalars(state, "mass");
  cloud.pressure = scalars(state, "pressure");
  cloud.water = scalars(state, "water");
  return cloud;
}

}  // namespace

template <int dim>
double Cloud<dim>::total_mass() const {
  double sum = 0;
  for (const double m : mass) sum += m;
  return sum;
}

template <int dim>
double Cloud<dim>::mean(const std::function<double(std::size_t)>& f) const {
  double sum = 0;
  for (std::size_t p = 0; p < size(); ++p) sum += mass[p] * f(p);
  return sum / total_mass();
}

template <int dim>
double Cloud<dim>::mean_velocity(int axis) const {
  return mean([&](std::size_t p) { return velocity[p][static_cast<std::size_t>(axis)]; });
}

template <int dim>
double Cloud<dim>::kinetic_energy() const {
  double sum = 0;
  for (std::size_t p = 0; p < size(); ++p)
    for (const double v : velocity[p]) sum += 0.5 * mass[p] * v * v;
  return sum;
}

template <int dim>
double Cloud<dim>::highest(int axis) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& x : position) most = std::max(most, x[static_cast<std::size_t>(axis)]);
  return most;
}

template <int dim>
Motion<dim> move(const mpm::Problem<dim>& problem, const std::function<bool(const Cloud<dim>&)>& enough) {
  mpm::Simulation<dim> simulation(problem);
  Motion<dim> motion;
  const auto& times = problem.output_times;
  motion.start = cloud_of<dim>(simulation.state());
  if (!times.empty() && times.front() == 0) motion.clouds.push_back(motion.start);
  while (!simulation.finished()) {
    simulation.step();
    const std::size_t next = motion.clouds.size();
    if (next >= times.size() || simulation.time() < times[next] * (1 - 1e-12)) continue;
    motion.clouds.push_back(cloud_of<dim>(simulation.state()));
    if (enough && enough(motion.clouds.back())) break;
  }
  motion.history = simulation.take_history();
  const auto steps = motion.history.counters.find("steps");
  motion.steps = steps == motion.history.counters.end() ? 0 : steps->second;
  motion.points = motion.clouds.empty() ? 0 : motion.clouds.back().size();
  return motion;
}

template struct Cloud<2>;
template struct Cloud<3>;
template Motion<2> move(const mpm::Problem<2>&, const std::function<bool(const Cloud<2>&)>&);
template Motion<3> move(const mpm::Problem<3>&, const std::function<bool(const Cloud<3>&)>&);

}  // namespace wetfront::verification
