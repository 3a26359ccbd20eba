#include "mpm/seepage/sparse_system.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>

#include <algorithm>

namespace wetfront::mpm {

struct SparseSystem::Implementation {
  using Matrix = Eigen::SparseMatrix<double>;
  Matrix matrix;
  std::vector<std::vector<int>> row_slots;
  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> direct;
  Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double>> iterative;
  bool analysed = false;

  bool solve_directly(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    if (!analysed) direct.analyzePattern(matrix);
    analysed = true;
    direct.factorize(matrix);
    if (direct.info() != Eigen::Success) return false;
    x = direct.solve(b);
    return x.allFinite();
  }

  bool solve_iteratively(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    // A Newton direction this exact costs no extra Newton iteration; ILUT keeps about half the fill of the matrix's own
    // rows.
    iterative.preconditioner().setDroptol(1e-3);
    iterative.preconditioner().setFillfactor(5);
    iterative.setTolerance(1e-8);
    iterative.setMaxIterations(500);
    iterative.compute(matrix);
    if (iterative.info() != Eigen::Success) return false;
    x = iterative.solve(b);
    return iterative.info() == Eigen::Success && x.allFinite();
  }
};

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
  values()[static_cast<std::size_t>(slot(row, row))] = 1;
}

bool SparseSystem::solve(std::span<const double> b, std::span<double> x) {
  const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXd>(b.data(), static_cast<Eigen::Index>(b.size()));
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(right.size());
  // The direct solver also catches a system that the iterative one cannot bring to its tolerance.
  const bool large = right.size() > direct_limit;
  const bool solved = (large && implementation_->solve_iteratively(right, solution)) ||
                      implementation_->solve_directly(right, solution);
  if (solved) std::copy(solution.begin(), solution.end(), x.begin());
  return solved;
}

std::string SparseSystem::method() const {
  return implementation_->matrix.rows() > direct_limit ? "BiCGSTAB + ILUT" : "sparse LU";
}

}  // namespace wetfront::mpm
