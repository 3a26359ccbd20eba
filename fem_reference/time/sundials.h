#pragma once

#include <sundials/sundials_nonlinearsolver.h>

#include <span>

/// What both SUNDIALS integrators need around the stage kernel.
namespace wetfront::fem_reference {

/// This rank's part of a vector.
std::span<double> view(N_Vector v);

/// Throws std::runtime_error naming the call when its flag is negative.
void check(int flag, const char* what);

/// A nonlinear solver that is nothing but `solve`; its content is the integrator.
SUNNonlinearSolver make_stage_solver(void* integrator, decltype(_generic_SUNNonlinearSolver_Ops::solve) solve,
                                     SUNContext context);

}  // namespace wetfront::fem_reference
