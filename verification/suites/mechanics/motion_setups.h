#pragma once

#include "mpm/problem.h"
#include "verification/suites/box_mesh.h"
#include "verification/suites/case_book.h"

#include <functional>
#include <string>
#include <vector>

/// What the problems of the suite have in common: dry soil, one dynamic stage. SI units.
namespace wetfront::verification {

/// Elastic soil without water whose bulk (dry) density is `density`: half of it pores.
mpm::Soil dry_soil(double density, double young, double poisson);
/// The same, limited by Mohr and Coulomb. Angles in rad.
mpm::Soil frictional_soil(double density, const mpm::Elastic& elastic, const mpm::MohrCoulomb& strength);

/// One soil in a mesh, a dynamic stage until the last of `times`, outputs at these.
template <int dim>
mpm::Problem<dim> dry_problem(meshes::Mesh mesh, mpm::Soil soil, const std::vector<double>& times);

/// Keeps sides of a box_mesh from moving along their normals.
template <int dim>
void add_rollers(mpm::Problem<dim>& problem, const std::vector<std::string>& sides);

/// Leaves soil only in cells whose centre satisfies `inside`.
template <int dim>
void fill_only(mpm::Problem<dim>& problem, const std::function<bool(const meshes::Point&)>& inside);

/// `count` times from end/count to end.
std::vector<double> evenly(double end, int count);

/// "linear", "linear, B-bar", "quadratic splines", with "APIC" or a share of PIC: what differs from plain MUSL with
/// FLIP.
std::string scheme_text(const mpm::SkeletonScheme& scheme);

/// What mapping may take of the energy of a smooth motion on so many cells: nothing with FLIP, else `cells_lost` /
/// cells.
Gate smooth_energy(const mpm::SkeletonScheme& scheme, int cells, double cells_lost = 1.6);
/// What it may make where it may lose so much: a tenth of it; of FLIP, whose gate is round-off, as much.
Gate smooth_energy_made(const Gate& lost);
/// What it may lose where weight, contact or damping act.
extern const Gate weighty_energy;

}  // namespace wetfront::verification
