#pragma once

#include "meshes/field_history.h"
#include "mpm/problem.h"

namespace wetfront::verification {

/// How much free energy the water of a rigid soil has gained beyond the work that boundaries did on it, at the worst of
/// the snapshots, over the energy converted until then; 0 where it has only lost. NaN where boundaries drain freely,
/// whose work the record does not tell, and where the surface cuts cells.
///
/// E = sum over the corners of cells of n V [rho g z S + integral of p dS]; Darcy's flow turns free energy into heat
/// (dE/dt = work - sum of K |grad H|^2), so that any gain is the scheme's own doing. The rain brings at most rho g z of
/// the surface, what leaves through a side takes p + rho g z with it.
double free_energy_growth(const mpm::Problem<2>& problem, const meshes::FieldHistory& history);

/// The van Genuchten curve of a soil of these suites: S of a pressure, by a formula of its own (the solvers have
/// theirs, and tables). Throws std::bad_variant_access for another curve.
double saturation(const mpm::Soil& soil, double pressure);

/// Volume of water per pore volume: S, and what p > 0 compresses.
double water_content(const mpm::Soil& soil, const mpm::Water& water, double pressure);

/// Energy that it takes to fill a pore volume from p = 0 [Pa]: integral of p dS.
double capillary_energy(const mpm::Soil& soil, const mpm::Water& water, double pressure);

}  // namespace wetfront::verification
