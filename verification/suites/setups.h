#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/exact/van_genuchten.h"
#include "verification/suites/box_mesh.h"

/// What the problems of the suites have in common. SI units.
namespace wetfront::verification {

constexpr double hour = 3600, day = 86400, cm = 0.01, cm_per_hour = cm / hour, cm_per_day = cm / day;

/// Gardner's soil: theta and K exponential with the same alpha [1/m].
fem_reference::Soil gardner_soil(double theta_r, double theta_s, double alpha, double conductivity);

/// van Genuchten's with Mualem's conductivity. The closed forms' own parameter struct, in SI, is the input, so that a
/// case states its soil once; the formulas stay the reference's own.
fem_reference::Soil van_genuchten_soil(const exact::VanGenuchten& soil);

/// A vertical line of equal cells with uniform head, outputs at `times`, which end the problem.
fem_reference::RichardsProblem column(double height, int cells, double head, const std::vector<double>& times);

/// The initial head of every node by its position.
void start_from(fem_reference::RichardsProblem& problem, const std::function<double(const meshes::Point&)>& head);

/// Head [m] at a height in a column (dim 1) by linear interpolation between its nodes, which must ascend.
double head_at_height(const meshes::Mesh& mesh, const std::vector<double>& heads, double height);

/// Height of the highest place where the nodal `values` of a column pass `level` (NaN: nowhere), linear between nodes.
double height_where(const meshes::Mesh& mesh, const std::vector<double>& values, double level);

}  // namespace wetfront::verification
