#include "mpm/coupling/elastic_solve.h"
#include "mpm/grid/soils_of_cells.h"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace wetfront::mpm {

namespace {

/// Modes without stiffness (hourglasses of cells with one point, loose points) get this part of the mean diagonal.
constexpr double softest = 1e-9;
/// A cell with one point has hourglasses without stiffness, and they turn as the point moves: it gets this part of the
/// mean diagonal against them, which costs elastic corrections some of their exactness.
constexpr double hourglass = 0.02;

}  // namespace

template <int dim>
struct ElasticSolve<dim>::Implementation {
  static constexpr int n = cell_nodes<dim>, dofs = n * dim;
  using CellMatrix = Eigen::Matrix<double, dofs, dofs>;

  const StagePlan<dim>& plan;
  std::vector<char> fixed;
  std::vector<int> unknown;  ///< of every node and axis; -1: fixed or not touched
  int unknowns = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  bool ready = false;

  CellMatrix stiffness(std::span<const Block* const> blocks) const;
  void number();
  bool factorise();
};

template <int dim>
typename ElasticSolve<dim>::Implementation::CellMatrix ElasticSolve<dim>::Implementation::stiffness(
    std::span<const Block* const> blocks) const {
  const auto& grid = plan.fields.grid;
  const Column& volume = *plan.fields.points.columns.find("volume");
  CellMatrix k = CellMatrix::Zero();
  Eigen::Matrix<double, dofs, 1> mean = Eigen::Matrix<double, dofs, 1>::Zero();
  const bool averaged = plan.problem.skeleton.locking == LockingRemedy::b_bar;
  double whole = 0, mean_bulk = 0;
  std::size_t count = 0;
  Stencil<dim> s;
  for (const Block* block : blocks) {
    const Elastic& elastic = *plan.problem.soils[static_cast<std::size_t>(block->soil)].elastic;
    const double shear = elastic.young / (2 * (1 + elastic.poisson)), bulk = elastic.young / (3 - 6 * elastic.poisson);
    double own = 0;
    for (std::size_t p = block->first; p < block->first + block->count; ++p) {
      grid.stencil(block->cell, grid.local(block->cell, plan.fields.points.position(p)), s);
      const double v = volume[0][p];
      own += v;
      for (int i = 0; i < n; ++i)
        for (int a = 0; a < dim; ++a) mean[i * dim + a] += v * s.gradient[i][a];
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          for (int a = 0; a < dim; ++a)
            for (int b = 0; b < dim; ++b) {
              double entry = s.gradient[i][b] * s.gradient[j][a] - 2.0 / 3 * s.gradient[i][a] * s.gradient[j][b];
              if (a == b) entry += dot<dim>(s.gradient[i], s.gradient[j]);
              if (!averaged) entry += bulk / shear * s.gradient[i][a] * s.gradient[j][b];
              k(i * dim + a, j * dim + b) += v * shear * entry;
            }
    }
    whole += own;
    mean_bulk += (bulk - mean_bulk) * (own / whole);
    count += block->count;
  }
  if (count == 1) k.diagonal().array() += hourglass * k.trace() / dofs;
  // The soils of a cell share its mean strain.
  if (averaged) k += mean_bulk / whole * mean * mean.transpose();
  return k;
}

template <int dim>
void ElasticSolve<dim>::Implementation::number() {
  unknown.assign(fixed.size(), -1);
  unknowns = 0;
  for (const Block& block : plan.fields.points.blocks())
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) unknown[static_cast<std::size_t>(block.nodes[i] * dim + a)] = 0;
  for (std::size_t d = 0; d < fixed.size(); ++d) unknown[d] = unknown[d] == 0 && !fixed[d] ? unknowns++ : -1;
}

template <int dim>
bool ElasticSolve<dim>::Implementation::factorise() {
  number();
  std::vector<Eigen::Triplet<double>> entries;
  double trace = 0;
  each_cell(plan.fields.points, [&](std::span<const Block* const> blocks) {
    const CellMatrix k = stiffness(blocks);
    const int* nodes = blocks.front()->nodes;
    for (int i = 0; i < dofs; ++i)
      for (int j = 0; j < dofs; ++j) {
        const int row = unknown[static_cast<std::size_t>(nodes[i / dim] * dim + i % dim)];
        const int column = unknown[static_cast<std::size_t>(nodes[j / dim] * dim + j % dim)];
        if (row >= 0 && column >= 0) entries.emplace_back(row, column, k(i, j));
        if (row >= 0 && i == j) trace += k(i, j);
      }
  });
  const double least = softest * trace / std::max(1, unknowns);
  for (int d = 0; d < unknowns; ++d) entries.emplace_back(d, d, least);
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors.compute(matrix);
  ready = unknowns > 0 && factors.info() == Eigen::Success;
  return ready;
}

template <int dim>
ElasticSolve<dim>::ElasticSolve(const StagePlan<dim>& plan, const std::array<std::vector<int>, 3>& fixed)
    : implementation_(new Implementation{plan, {}, {}, 0, {}, false}) {
  implementation_->fixed.assign(plan.fields.grid.node_count() * dim, 0);
  for (int a = 0; a < dim; ++a)
    for (int node : fixed[static_cast<std::size_t>(a)])
      implementation_->fixed[static_cast<std::size_t>(node * dim + a)] = 1;
}

template <int dim>
ElasticSolve<dim>::~ElasticSolve() = default;

template <int dim>
bool ElasticSolve<dim>::factorise() {
  return implementation_->factorise();
}

template <int dim>
bool ElasticSolve<dim>::ready() const {
  return implementation_->ready;
}

template <int dim>
void ElasticSolve<dim>::solve(const Column& force, Column& displacement) const {
  const auto& unknown = implementation_->unknown;
  const std::size_t nodes = force.size();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(implementation_->unknowns);
  for (std::size_t i = 0; i < nodes; ++i)
    for (int a = 0; a < dim; ++a)
      if (const int d = unknown[i * dim + static_cast<std::size_t>(a)]; d >= 0) right[d] = force[a][i];
  const Eigen::VectorXd u = implementation_->factors.solve(right);
  for (std::size_t i = 0; i < nodes; ++i)
    for (int a = 0; a < dim; ++a) {
      const int d = unknown[i * dim + static_cast<std::size_t>(a)];
      displacement[a][i] = d >= 0 ? u[d] : 0.0;
    }
}

template class ElasticSolve<2>;
template class ElasticSolve<3>;

}  // namespace wetfront::mpm
