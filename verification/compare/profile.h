#pragma once

#include "meshes/field_history.h"

#include <vector>

namespace wetfront::verification {

/// Pressure and saturation at the centres of the candidate's cells at one time: the common ground on which two
/// solutions on different meshes are compared.
struct Profile {
  double time = 0;
  std::vector<double> pressure;    ///< Pa
  std::vector<double> saturation;  ///< -
};

/// Cell values of the candidate, one profile per snapshot.
std::vector<Profile> cell_profiles(const meshes::FieldHistory& candidate);

/// Another solution in the candidate's cells: at their centres, or averaged over them at times at which the candidate's
/// cell values are averages. A one-dimensional solution is read at the places' elevations.
std::vector<Profile> profiles_at_cells(const meshes::FieldHistory& history, const meshes::FieldHistory& candidate);

/// Nodal fields of a mesh at the nodes of `nodes_of`, one for one, 0 outside; the places are found once for all.
std::vector<std::vector<double>> values_at_nodes(const meshes::Mesh& mesh,
                                                 const std::vector<const std::vector<double>*>& nodal,
                                                 const meshes::Mesh& nodes_of);
/// Pressure of another solution at the nodes of `nodes_of`, one field per snapshot.
std::vector<std::vector<double>> pressure_at_nodes(const meshes::FieldHistory& history, const meshes::Mesh& nodes_of);

/// The weights of the norms: cell volumes; 0 for a cell whose centre lies outside the reference's mesh (the background
/// grid may reach above the ground), which no norm looks at.
std::vector<double> cell_weights(const meshes::Mesh& mesh, const meshes::Mesh& reference);
/// 1 per node inside the reference's mesh, 0 outside.
std::vector<double> node_weights(const meshes::Mesh& mesh, const meshes::Mesh& reference);

/// ||a - b||_2 / ||b||_2 with weights (benchmarks: the norm used for every column).
double relative_l2(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight);

/// Root mean square of a - b with weights, in the unit of a.
double root_mean_square(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight);

/// max |a - b| / max |b| over what has a weight.
double relative_linf(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight);

/// Elevation where saturation, going down from the surface, first falls to the mean of its value in the uppermost
/// cell and the driest cell below; NaN where the surface is (within 0.01) the driest, before the rain or after the
/// front has met the water table. Columns only: `elevation` ascending, one value per cell.
double front_elevation(const std::vector<double>& saturation, const std::vector<double>& elevation);

}  // namespace wetfront::verification
