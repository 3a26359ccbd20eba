#include "fem_reference/time/sundials.h"

#include <nvector/nvector_parallel.h>

#include <stdexcept>
#include <string>

namespace wetfront::fem_reference {

std::span<double> view(N_Vector v) {
  const bool divided = N_VGetVectorID(v) == SUNDIALS_NVEC_PARALLEL;
  return {N_VGetArrayPointer(v), static_cast<std::size_t>(divided ? NV_LOCLENGTH_P(v) : N_VGetLength(v))};
}

void check(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(std::string(what) + " failed with flag " + std::to_string(flag));
}

SUNNonlinearSolver make_stage_solver(void* integrator, decltype(_generic_SUNNonlinearSolver_Ops::solve) solve,
                                     SUNContext context) {
  SUNNonlinearSolver solver = SUNNonlinSolNewEmpty(context);
  solver->content = integrator;
  solver->ops->gettype = [](SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; };
  solver->ops->initialize = [](SUNNonlinearSolver) { return SUN_NLS_SUCCESS; };
  solver->ops->setsysfn = [](SUNNonlinearSolver, SUNNonlinSolSysFn) { return SUN_NLS_SUCCESS; };
  solver->ops->free = [](SUNNonlinearSolver) { return SUN_NLS_SUCCESS; };
  solver->ops->solve = solve;
  return solver;
}

}  // namespace wetfront::fem_reference
