#include "mpm/grid/cell_values.h"

#include <algorithm>
#include <map>
#include <utility>

namespace wetfront::mpm {

namespace {

using SoilOf = std::function<int(std::size_t)>;

template <int dim>
struct MeanGradient {
  Vector<dim> sum{};
  int cells = 0;
};

/// Gradients at (node, soil): the mean over that soil's cells around the node.
template <int dim>
using NodalGradients = std::map<std::pair<int, int>, MeanGradient<dim>>;

template <int dim>
NodalGradients<dim> average_gradients(const Grid<dim>& grid, const double* nodal, const SoilOf& soil_of) {
  NodalGradients<dim> gradients;
  Stencil<dim> stencil;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const int soil = soil_of(cell);
    if (soil < 0) continue;
    const int* nodes = grid.cell_nodes_of(cell);
    grid.stencil(cell, Vector<dim>{}, stencil);
    Vector<dim> gradient{};
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) gradient[a] += stencil.gradient[i][a] * nodal[nodes[i]];
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      MeanGradient<dim>& mean = gradients[{nodes[i], soil}];
      for (int a = 0; a < dim; ++a) mean.sum[a] += gradient[a];
      ++mean.cells;
    }
  }
  return gradients;
}

}  // namespace

template <int dim>
std::vector<double> cell_values(const Grid<dim>& grid, const double* nodal, const SoilOf& soil_of) {
  const auto gradients = average_gradients(grid, nodal, soil_of);
  std::vector<double> values;
  values.reserve(grid.cell_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const int* nodes = grid.cell_nodes_of(cell);
    const Vector<dim> centre = grid.place(cell, Vector<dim>{});
    // Cells without soil take the gradients of the ground's own layout beside them.
    const int found = soil_of(cell), soil = found >= 0 ? found : grid.region(cell);
    double value = 0, low = nodal[nodes[0]], high = low;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      double step = 0;
      if (const auto mean = gradients.find({nodes[i], soil}); mean != gradients.end())
        for (int a = 0; a < dim; ++a)
          step += mean->second.sum[a] / mean->second.cells * (centre[a] - grid.node(nodes[i])[a]);
      value += (nodal[nodes[i]] + 0.5 * step) / cell_nodes<dim>;
      low = std::min(low, nodal[nodes[i]]);
      high = std::max(high, nodal[nodes[i]]);
    }
    values.push_back(std::clamp(value, low, high));
  }
  return values;
}

template std::vector<double> cell_values<2>(const Grid<2>&, const double*, const SoilOf&);
template std::vector<double> cell_values<3>(const Grid<3>&, const double*, const SoilOf&);

}  // namespace wetfront::mpm
