#include "verification/suites/setups.h"

#include <algorithm>
#include <limits>

namespace wetfront::verification {
namespace fem = fem_reference;

fem::Soil gardner_soil(double theta_r, double theta_s, double alpha, double conductivity) {
  fem::Soil soil;
  soil.name = "Gardner";
  soil.retention = fem::ExponentialRetention{theta_r, theta_s, alpha};
  soil.conductivity = fem::ExponentialConductivity{alpha};
  soil.saturated_conductivity = conductivity;
  return soil;
}

fem::Soil van_genuchten_soil(const exact::VanGenuchten& parameters) {
  fem::Soil soil;
  soil.name = "van Genuchten";
  soil.retention = fem::VanGenuchten{parameters.theta_r, parameters.theta_s, parameters.alpha, parameters.n};
  soil.conductivity = fem::MualemConductivity{};
  soil.saturated_conductivity = parameters.conductivity;
  return soil;
}

fem::RichardsProblem column(double height, int cells, double head, const std::vector<double>& times) {
  fem::RichardsProblem problem;
  problem.mesh = line_mesh(height, cells);
  problem.gravity_direction = {-1, 0, 0};
  problem.initial_head.assign(problem.mesh.node_count(), head);
  problem.output_times = times;
  problem.end_time = times.back();
  return problem;
}

void start_from(fem::RichardsProblem& problem, const std::function<double(const meshes::Point&)>& head) {
  problem.initial_head.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_head.push_back(head(node));
}

double head_at_height(const meshes::Mesh& mesh, const std::vector<double>& heads, double height) {
  const auto above = std::upper_bound(mesh.nodes.begin(), mesh.nodes.end(), height,
                                      [](double h, const meshes::Point& node) { return h < node[0]; });
  const auto last = static_cast<std::ptrdiff_t>(mesh.node_count()) - 1;
  const auto i = std::clamp<std::ptrdiff_t>(above - mesh.nodes.begin(), 1, last);
  const double low = mesh.nodes[i - 1][0], high = mesh.nodes[i][0], r = (height - low) / (high - low);
  return (1 - r) * heads[i - 1] + r * heads[i];
}

double height_where(const meshes::Mesh& mesh, const std::vector<double>& values, double level) {
  for (std::size_t i = values.size() - 1; i > 0; --i) {
    const double high = values[i] - level, low = values[i - 1] - level;
    if ((high > 0) == (low > 0)) continue;
    return mesh.nodes[i - 1][0] + low / (low - high) * (mesh.nodes[i][0] - mesh.nodes[i - 1][0]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace wetfront::verification
