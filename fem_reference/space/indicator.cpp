#include "fem_reference/space/indicator.h"

#include <algorithm>

namespace wetfront::fem_reference {
namespace {

// Joined cells show up to twice the change of their parts; well below the threshold, so that they stay joined a while.
constexpr double join_below = 0.2;
// Cells around a front that are halved with it: the way it may go until the mesh must follow.
constexpr int layers = 3;

}  // namespace

Indicator::Indicator(const RichardsProblem& problem) : adaptivity_(*problem.adaptivity) {}

std::vector<double> Indicator::change(const Discretisation& space, const std::vector<SoilLaw>& laws,
                                      std::span<const double> head) const {
  std::vector<double> result(space.cell_count);
  const int n = space.dofs_per_cell, corners = space.corners();
  for (int cell = 0; cell < space.cell_count; ++cell) {
    const double* shape = space.corner_shape_of(cell);
    const int* dof = space.dofs_of(cell);
    double low = 1, high = 0;
    for (int v = 0; v < corners; ++v) {
      double psi = 0;
      for (int a = 0; a < n; ++a) psi += shape[v * n + a] * head[dof[a]];
      const double content = laws[space.cell_soil[cell]].water_content(psi).value;
      low = std::min(low, content);
      high = std::max(high, content);
    }
    result[cell] = high - low;
  }
  return result;
}

bool Indicator::due(const Discretisation& space, const std::vector<SoilLaw>& laws, std::span<const double> head) const {
  const std::vector<double> found = change(space, laws, head);
  for (int cell = 0; cell < space.cell_count; ++cell) {
    if (space.box[cell].level < adaptivity_.levels && found[cell] > adaptivity_.threshold) return true;
  }
  return false;
}

bool Indicator::mostly_joinable(const Discretisation& space, const std::vector<SoilLaw>& laws,
                                std::span<const double> head) const {
  const std::vector<Space::Mark> found = marks(space, laws, head);
  return 2 * std::count(found.begin(), found.end(), Space::Mark::join) > space.cell_count;
}

// Cells that share an unknown with a cell that wants a level want it too, layer by layer.
void Indicator::spread(const Discretisation& space, std::vector<int>& level) const {
  std::vector<int> at_dof(space.dof_count);
  for (int layer = 0; layer < layers; ++layer) {
    std::fill(at_dof.begin(), at_dof.end(), 0);
    const int n = space.dofs_per_cell;
    for (int cell = 0; cell < space.cell_count; ++cell) {
      for (int a = 0; a < n; ++a) {
        int& there = at_dof[space.dofs_of(cell)[a]];
        there = std::max(there, level[cell]);
      }
    }
    for (int cell = 0; cell < space.cell_count; ++cell) {
      for (int a = 0; a < n; ++a) level[cell] = std::max(level[cell], at_dof[space.dofs_of(cell)[a]]);
    }
  }
}

std::vector<Space::Mark> Indicator::marks(const Discretisation& space, const std::vector<SoilLaw>& laws,
                                          std::span<const double> head) const {
  const std::vector<double> found = change(space, laws, head);
  const double threshold = adaptivity_.threshold;
  std::vector<int> wanted(space.cell_count);
  for (int cell = 0; cell < space.cell_count; ++cell) {
    const int level = space.box[cell].level;
    if (found[cell] > threshold || threshold == 0) {  // 0: everywhere
      wanted[cell] = std::min(level + 1, adaptivity_.levels);
    } else {
      wanted[cell] = found[cell] < join_below * threshold ? std::max(0, level - 1) : level;
    }
  }
  std::vector<int> spread_level(space.cell_count, 0);
  for (int cell = 0; cell < space.cell_count; ++cell) {
    if (found[cell] > threshold) spread_level[cell] = wanted[cell];
  }
  spread(space, spread_level);
  std::vector<Space::Mark> marks(space.cell_count, Space::Mark::keep);
  for (int cell = 0; cell < space.cell_count; ++cell) {
    const int level = space.box[cell].level, target = std::max(wanted[cell], spread_level[cell]);
    if (target > level) marks[cell] = Space::Mark::halve;
    if (target < level) marks[cell] = Space::Mark::join;
  }
  return marks;
}

}  // namespace wetfront::fem_reference
