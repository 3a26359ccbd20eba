#include "fem_reference/linear/linear_solver.h"
#include "fem_reference/linear/petsc_session.h"

#include <petscksp.h>

#include <stdexcept>
#include <string>

namespace wetfront::fem_reference {
namespace {

void check(PetscErrorCode code, const char* what) {
  if (code != 0) throw std::runtime_error(std::string("PETSc: ") + what + " failed with code " + std::to_string(code));
}

/// One preconditioner and the iterations around it.
class Iteration {
 public:
  Iteration(Mat matrix, MPI_Comm comm, bool multigrid, int most_iterations) {
    check(KSPCreate(comm, &ksp_), "KSPCreate");
    KSPSetOperators(ksp_, matrix, matrix);
    KSPSetType(ksp_, KSPGMRES);
    KSPGMRESSetRestart(ksp_, most_iterations);
    KSPSetPCSide(ksp_, PC_RIGHT);  // so that the norm that is watched is the residual's own
    // A thousandth of what Newton leaves quadratically is lost on it: counts of Newton iterations stay UMFPACK's.
    constexpr double relative = 1e-6;
    tolerances_ = {relative, most_iterations};
    PC preconditioner;
    KSPGetPC(ksp_, &preconditioner);
    if (multigrid) {
      check(PCSetType(preconditioner, PCHYPRE), "hypre");
      check(PCHYPRESetType(preconditioner, "boomeramg"), "BoomerAMG");
    } else {
      check(PCSetType(preconditioner, PCBJACOBI), "block Jacobi");  // of incomplete factors: one block per rank
    }
  }
  ~Iteration() { KSPDestroy(&ksp_); }
  Iteration(const Iteration&) = delete;
  Iteration& operator=(const Iteration&) = delete;

  bool solve(Vec b, Vec x, double absolute) {
    KSPSetTolerances(ksp_, tolerances_.relative, absolute, PETSC_DEFAULT, tolerances_.most_iterations);
    if (KSPSolve(ksp_, b, x) != 0) return false;
    KSPConvergedReason reason;
    KSPGetConvergedReason(ksp_, &reason);
    return reason > 0;
  }

 private:
  KSP ksp_ = nullptr;
  struct {
    double relative;
    int most_iterations;
  } tolerances_{};
};

class KrylovSolver : public LinearSolver {
 public:
  KrylovSolver(const SparseMatrix& pattern, RowScale scale, const Ranks& ranks)
      : n_(pattern.size()), scale_(std::move(scale)), ranks_(ranks) {
    start_petsc();
    comm_ = ranks.count() > 1 ? MPI_COMM_WORLD : MPI_COMM_SELF;
    make_matrix(pattern);
    x0_.resize(n_ + ranks.ghosts());
    value_.resize(pattern.column.size());
  }
  ~KrylovSolver() override {
    factors_.reset();
    multigrid_.reset();
    MatDestroy(&matrix_);
    VecDestroy(&x_);
    VecDestroy(&b_);
  }
  KrylovSolver(const KrylovSolver&) = delete;
  KrylovSolver& operator=(const KrylovSolver&) = delete;

  bool solve(const SparseMatrix& matrix, std::vector<double>& b) override {
    take(matrix, b);
    if (!iterate()) {
      if (ranks_.count() > 1) return false;
      if (!direct_) direct_ = make_umfpack_solver();
      return direct_->solve(matrix, b);
    }
    const double* x = nullptr;
    check(VecGetArrayRead(x_, &x), "VecGetArrayRead");
    for (int i = 0; i < n_; ++i) b[i] = x0_[i] + x[i];
    VecRestoreArrayRead(x_, &x);
    return true;
  }

 private:
  void make_matrix(const SparseMatrix& pattern) {
    std::vector<PetscInt> rows, columns;
    const auto global = [&](int i) { return ranks_.count() > 1 ? ranks_.global()[i] : i; };
    for (int i = 0; i < n_; ++i) {
      rows.insert(rows.end(), pattern.row_start[i + 1] - pattern.row_start[i], global(i));
    }
    for (int column : pattern.column) columns.push_back(global(column));
    check(MatCreate(comm_, &matrix_), "MatCreate");
    MatSetSizes(matrix_, n_, n_, PETSC_DETERMINE, PETSC_DETERMINE);
    MatSetType(matrix_, MATAIJ);
    check(MatSetPreallocationCOO(matrix_, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()),
          "MatSetPreallocationCOO");
    check(MatCreateVecs(matrix_, &x_, &b_), "MatCreateVecs");
  }

  // Rows with a diagonal alone (held heads) are solved at once and leave the system: else their residuals, which are
  // heads and not water contents, would drown the others in the norm.
  void take(const SparseMatrix& matrix, const std::vector<double>& b) {
    for (int i = 0; i < n_; ++i) {
      double diagonal = 0;
      bool alone = true;
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        if (matrix.column[k] == i) {
          diagonal = matrix.value[k];
        } else if (matrix.value[k] != 0) {
          alone = false;
        }
      }
      x0_[i] = alone ? b[i] / diagonal : 0;
    }
    ranks_.refresh(x0_);
    double* rest = nullptr;
    check(VecGetArray(b_, &rest), "VecGetArray");
    for (int i = 0; i < n_; ++i) {
      double r = b[i];
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        const int j = matrix.column[k];
        r -= matrix.value[k] * x0_[j];
        value_[k] = x0_[j] != 0 && j != i ? 0 : matrix.value[k] / scale_.size[i];
      }
      rest[i] = x0_[i] != 0 ? 0 : r / scale_.size[i];
    }
    VecRestoreArray(b_, &rest);
    check(MatSetValuesCOO(matrix_, value_.data(), INSERT_VALUES), "MatSetValuesCOO");
  }

  // Incomplete factors are cheap and good while storage dominates; multigrid costs as much as some 50 of their
  // iterations (README) and then does not care how large and how saturated the soil is.
  bool iterate() {
    constexpr int most_with_factors = 50, most_with_multigrid = 200, spell = 20;
    const double absolute = 0.1 * scale_.tolerance;
    if (multigrid_left_ == 0) {
      if (!factors_) factors_ = std::make_unique<Iteration>(matrix_, comm_, false, most_with_factors);
      if (factors_->solve(b_, x_, absolute)) return true;
      multigrid_left_ = spell;
    }
    --multigrid_left_;
    if (!multigrid_) multigrid_ = std::make_unique<Iteration>(matrix_, comm_, true, most_with_multigrid);
    return multigrid_->solve(b_, x_, absolute);
  }

  int n_;
  RowScale scale_;
  Ranks ranks_;
  MPI_Comm comm_{};
  Mat matrix_ = nullptr;
  Vec x_ = nullptr, b_ = nullptr;
  std::unique_ptr<Iteration> factors_, multigrid_;
  std::unique_ptr<LinearSolver> direct_;
  int multigrid_left_ = 0;     ///< solves until incomplete factors are tried again
  std::vector<double> x0_;     ///< [own + ghost]: the solution where a row is a diagonal alone, else 0
  std::vector<double> value_;  ///< the matrix that is iterated on
};

}  // namespace

std::unique_ptr<LinearSolver> make_krylov_solver(const SparseMatrix& pattern, RowScale scale, const Ranks& ranks) {
  return std::make_unique<KrylovSolver>(pattern, std::move(scale), ranks);
}

}  // namespace wetfront::fem_reference
