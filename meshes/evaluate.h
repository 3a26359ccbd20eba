#pragma once

#include "meshes/mesh.h"

#include <optional>
#include <vector>

namespace wetfront::meshes {

/// Evaluates nodal fields of a mesh anywhere inside it, by the (multi)linear interpolation that both
/// solvers' fields are defined with.
class Evaluator {
 public:
  explicit Evaluator(const Mesh& mesh);

  /// The nodes and weights that interpolate at a point. The point may lie outside by at most 1e-9 of
  /// the mesh's extent; farther out throws std::out_of_range.
  struct Weights {
    std::vector<int> node;
    std::vector<double> weight;
  };
  Weights weights(const Point& point) const;
  /// The same, nothing where weights() throws.
  std::optional<Weights> weights_if_inside(const Point& point) const;

  int dim() const { return mesh_->dim; }

  /// Value of a nodal field at a point.
  double operator()(const std::vector<double>& nodal, const Point& point) const;

 private:
  const Mesh* mesh_;
  std::vector<int> order_;     ///< cells by their lower end along the search axis
  std::vector<double> lower_;  ///< that lower end, ascending
  double largest_extent_ = 0;  ///< of a cell along the search axis
  double tolerance_ = 0;       ///< m
};

}  // namespace wetfront::meshes
