#include "fem_reference/linear/linear_solver.h"

#include <umfpack.h>

namespace wetfront::fem_reference {
namespace {

/// UMFPACK, with the symbolic analysis done once. Compressed rows are the compressed columns of the transpose,
/// so the transposed system is solved.
class UmfpackSolver : public LinearSolver {
 public:
  UmfpackSolver() { umfpack_di_defaults(control_); }
  ~UmfpackSolver() override {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }
  UmfpackSolver(const UmfpackSolver&) = delete;
  UmfpackSolver& operator=(const UmfpackSolver&) = delete;

  bool solve(const SparseMatrix& matrix, std::vector<double>& b) override {
    const int n = matrix.size();
    const int* start = matrix.row_start.data();
    const int* column = matrix.column.data();
    const double* value = matrix.value.data();
    if (symbolic_ == nullptr &&
        umfpack_di_symbolic(n, n, start, column, value, &symbolic_, control_, nullptr) != UMFPACK_OK) {
      return false;
    }
    umfpack_di_free_numeric(&numeric_);
    if (umfpack_di_numeric(start, column, value, symbolic_, &numeric_, control_, nullptr) != UMFPACK_OK) return false;
    solution_.resize(n);
    if (umfpack_di_solve(UMFPACK_At, start, column, value, solution_.data(), b.data(), numeric_, control_, nullptr) !=
        UMFPACK_OK) {
      return false;
    }
    b.swap(solution_);
    return true;
  }

 private:
  double control_[UMFPACK_CONTROL];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  std::vector<double> solution_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_umfpack_solver() {
  return std::make_unique<UmfpackSolver>();
}

}  // namespace wetfront::fem_reference
