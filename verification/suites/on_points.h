#pragma once

#include "fem_reference/richards_problem.h"
#include "mpm/problem.h"

namespace wetfront::verification {

/// A problem of the reference in the terms of the material point method: pressures for heads, intrinsic permeability
/// for conductivity, a strip one cell wide for a line. One stage, `seepage`, ending where the problem does; outputs,
/// gauges and boundary conditions as they are. So a case states its problem once. Water is of 1 mPa s and 1000 kg/m3.
/// Throws std::invalid_argument for what the MPM has no terms for (three dimensions, sources, heads by a function).
mpm::Problem<2> on_points(const fem_reference::RichardsProblem& problem);

/// A line of cells as a strip one cell wide: node i of the line becomes nodes 2 i (left, on the axis) and 2 i + 1. The
/// ends keep their names; "left" and "right" are new.
meshes::Mesh strip_of(const meshes::Mesh& line);

/// The left nodes of a strip: the nodal field of the line it was made of; a run on the strip as one on the line (mesh,
/// nodal fields and the rest, but no cells and points).
std::vector<double> on_line(const std::vector<double>& strip_nodes);
meshes::FieldHistory on_line(const meshes::FieldHistory& strip, const meshes::Mesh& line);

}  // namespace wetfront::verification
