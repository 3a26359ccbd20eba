#include "mpm/seepage/sparse_system.h"

#include <Eigen/IterativeLinearSolvers>

#include <klu.h>
#include <algorithm>

namespace wetfront::mpm {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// A Newton direction this exact costs no extra Newton iteration.
constexpr double good_enough = 1e-8;
// Pivots of these flows stand on the diagonal, whatever their size; a solution that is not good enough takes the
// largest of the column.
constexpr double pivot_of_diagonal = 0, largest_pivot = 1;

bool solves(const Matrix& matrix, const Vector& b, const Vector& x) {
  return x.allFinite() && (matrix * x - b).lpNorm<Eigen::Infinity>() <= good_enough * b.lpNorm<Eigen::Infinity>();
}

/// Left-looking LU with fill-reducing order (Davis & Palamadai Natarajan 2010, "KLU"). The order is made once for a
/// pattern. Pivots stay on the diagonal, so a factorisation anew does what the first one did: a run that goes on from
/// a checkpoint has the same bits.
class DirectSolver {
 public:
  explicit DirectSolver(Matrix& matrix) : matrix_(matrix) {
    klu_defaults(&common_);
    common_.btf = 0;
    common_.tol = pivot_of_diagonal;
    symbolic_ = klu_analyze(rows(), matrix.outerIndexPtr(), matrix.innerIndexPtr(), &common_);
  }
  ~DirectSolver() {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Floating-point operations of one factorisation.
  double operations() const { return symbolic_ != nullptr ? symbolic_->est_flops : 0; }
  bool solve(const Vector& b, Vector& x) {
    return symbolic_ != nullptr && ((factorise() && substitute(numeric_, b, x)) || solve_with_pivoting(b, x));
  }

 private:
  int rows() const { return static_cast<int>(matrix_.rows()); }
  bool factorise() {
    if (numeric_ != nullptr)
      return klu_refactor(matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(), symbolic_, numeric_,
                          &common_) != 0;
    numeric_ = klu_factor(matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(), symbolic_, &common_);
    return numeric_ != nullptr;
  }
  bool substitute(klu_numeric* numeric, const Vector& b, Vector& x) {
    x = b;
    return klu_solve(symbolic_, numeric, rows(), 1, x.data(), &common_) != 0 && solves(matrix_, b, x);
  }
  bool solve_with_pivoting(const Vector& b, Vector& x) {
    common_.tol = largest_pivot;
    klu_numeric* numeric =
        klu_factor(matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(), symbolic_, &common_);
    common_.tol = pivot_of_diagonal;
    const bool solved = numeric != nullptr && substitute(numeric, b, x);
    klu_free_numeric(&numeric, &common_);
    return solved;
  }

  Matrix& matrix_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

bool solve_iteratively(const Matrix& matrix, const Vector& b, Vector& x) {
  Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double>> solver;
  // ILUT keeps about half the fill of the matrix's own rows.
  solver.preconditioner().setDroptol(1e-3);
  solver.preconditioner().setFillfactor(5);
  solver.setTolerance(good_enough);
  solver.setMaxIterations(500);
  solver.compute(matrix);
  if (solver.info() != Eigen::Success) return false;
  x = solver.solve(b);
  return solver.info() == Eigen::Success && x.allFinite();
}

}  // namespace

struct SparseSystem::Implementation {
  Matrix matrix;  ///< of all rows
  std::vector<std::vector<int>> row_slots;
  std::vector<int> diagonal;  ///< slots
  /// Rows with couplings, what is solved for: grids have several times as many nodes without soil.
  std::vector<int> coupled;
  Matrix inner;            ///< of the coupled rows
  std::vector<int> slots;  ///< of each entry of `inner` in `matrix`
  std::unique_ptr<DirectSolver> direct;

  bool iterates() const {
    return direct->operations() > most_operations_per_entry * static_cast<double>(inner.nonZeros());
  }
  void find_coupled(const std::vector<std::pair<int, int>>& couplings);
  bool solve_coupled(const Vector& b, Vector& x) {
    if (coupled.empty()) return true;
    for (int k = 0; k < inner.nonZeros(); ++k)
      inner.valuePtr()[k] = matrix.valuePtr()[slots[static_cast<std::size_t>(k)]];
    // The direct solver also catches a system that the iterative one cannot bring to its tolerance.
    return (iterates() && solve_iteratively(inner, b, x)) || direct->solve(b, x);
  }
};

void SparseSystem::Implementation::find_coupled(const std::vector<std::pair<int, int>>& couplings) {
  std::vector<int> place(static_cast<std::size_t>(matrix.rows()), 0);
  for (const auto& [row, column] : couplings)
    if (row != column) place[static_cast<std::size_t>(row)] = place[static_cast<std::size_t>(column)] = 1;
  for (int row = 0; row < matrix.rows(); ++row) {
    int& its = place[static_cast<std::size_t>(row)];
    if (its == 1) coupled.push_back(row);
    its = its == 1 ? static_cast<int>(coupled.size()) - 1 : -1;
  }
  const auto n = static_cast<Eigen::Index>(coupled.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int column : coupled)
    for (int k = matrix.outerIndexPtr()[column]; k < matrix.outerIndexPtr()[column + 1]; ++k) {
      const int row = matrix.innerIndexPtr()[k];
      entries.emplace_back(place[static_cast<std::size_t>(row)], place[static_cast<std::size_t>(column)], 0.0);
      slots.push_back(k);
    }
  // Rows keep their order, so the entries of `inner` come in that of `slots`.
  inner.resize(n, n);
  inner.setFromTriplets(entries.begin(), entries.end());
  inner.makeCompressed();
  direct = std::make_unique<DirectSolver>(inner);
}

SparseSystem::SparseSystem(int rows, const std::vector<std::pair<int, int>>& couplings)
    : implementation_(std::make_unique<Implementation>()) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [row, column] : couplings) entries.emplace_back(row, column, 0.0);
  for (int row = 0; row < rows; ++row) entries.emplace_back(row, row, 0.0);
  auto& matrix = implementation_->matrix;
  matrix.resize(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  matrix.makeCompressed();
  implementation_->row_slots.resize(static_cast<std::size_t>(rows));
  for (int k = 0; k < matrix.nonZeros(); ++k)
    implementation_->row_slots[static_cast<std::size_t>(matrix.innerIndexPtr()[k])].push_back(k);
  for (int row = 0; row < rows; ++row) implementation_->diagonal.push_back(slot(row, row));
  implementation_->find_coupled(couplings);
}

SparseSystem::~SparseSystem() = default;

int SparseSystem::slot(int row, int column) const {
  const auto& matrix = implementation_->matrix;
  const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - matrix.innerIndexPtr());
}

std::span<double> SparseSystem::values() {
  auto& matrix = implementation_->matrix;
  return {matrix.valuePtr(), static_cast<std::size_t>(matrix.nonZeros())};
}

void SparseSystem::make_identity_row(int row) {
  for (int k : implementation_->row_slots[static_cast<std::size_t>(row)]) values()[static_cast<std::size_t>(k)] = 0;
  values()[static_cast<std::size_t>(implementation_->diagonal[static_cast<std::size_t>(row)])] = 1;
}

bool SparseSystem::solve(std::span<const double> b, std::span<double> x) {
  const std::vector<int>& coupled = implementation_->coupled;
  Vector right(static_cast<Eigen::Index>(coupled.size())), solution(right.size());
  for (std::size_t i = 0; i < coupled.size(); ++i)
    right[static_cast<Eigen::Index>(i)] = b[static_cast<std::size_t>(coupled[i])];
  if (!implementation_->solve_coupled(right, solution)) return false;
  for (std::size_t row = 0; row < b.size(); ++row)
    x[row] = b[row] / values()[static_cast<std::size_t>(implementation_->diagonal[row])];
  for (std::size_t i = 0; i < coupled.size(); ++i)
    x[static_cast<std::size_t>(coupled[i])] = solution[static_cast<Eigen::Index>(i)];
  return true;
}

bool SparseSystem::iterates() const {
  return implementation_->iterates();
}

}  // namespace wetfront::mpm
