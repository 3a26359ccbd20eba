#include "fem_reference/time/integrator.h"

#include <algorithm>
#include <sstream>

namespace wetfront::fem_reference {

std::vector<double> head_rates(const FlowOperator& flow, const std::vector<double>& water_rates) {
  constexpr double least_capacity = 1e-6;  // 1/m; below it dpsi/dt = dW/dt / C only makes the first step tiny
  std::vector<double> rates(water_rates.size(), 0.0);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (flow.capacity()[i] > least_capacity) rates[i] = water_rates[i] / flow.capacity()[i];
  }
  return rates;
}

std::string describe_failure(const StageKernel& kernel, double time, double step, std::string reason) {
  const StageKernel::Failure& failure = kernel.failure();
  const Discretisation& space = kernel.flow().space();
  const auto found = std::find(space.cell_dofs.begin(), space.cell_dofs.end(), failure.dof);
  const auto element = (found - space.cell_dofs.begin()) / space.dofs_per_cell;
  if (reason.empty()) reason = failure.reason.empty() ? "the error test kept failing" : failure.reason;
  std::ostringstream text;
  text << "gave up at t = " << time << " s with a step of " << step << " s: " << reason << "; worst in element "
       << (space.ranks.count() > 1 ? space.mesh_cell[element] : element) << " at (";
  for (int axis = 0; axis < space.dim; ++axis) text << (axis > 0 ? ", " : "") << space.position[failure.dof][axis];
  text << ") m, pressure head " << failure.head << " m; residuals [m3/m3]";
  for (double r : failure.residuals) text << ' ' << r;
  return space.ranks.text_of_largest(failure.worst, text.str());
}

}  // namespace wetfront::fem_reference
