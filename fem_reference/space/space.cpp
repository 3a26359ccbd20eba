#include "fem_reference/space/space.h"

#include "fem_reference/space/fill_space.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/distributed/p4est_wrappers.h>
#include <deal.II/distributed/tria.h>

namespace wetfront::fem_reference {

class Space::Triangulated {
 public:
  virtual ~Triangulated() = default;
  virtual Discretisation fill() const = 0;
  virtual bool adapt(const std::vector<Mark>& marks) = 0;
};

namespace {

/// `Tria`: a mesh that one process holds whole, or one that p4est divides among the ranks (which stays as it is).
template <int dim, class Tria>
class Refinable : public Space::Triangulated {
 public:
  template <class... Arguments>
  explicit Refinable(const RichardsProblem& problem, Arguments&&... arguments)
      : problem_(problem), triangulation_(arguments...), fe_(problem.degree), mapping_(1), dofs_(triangulation_) {
    triangulate(problem.mesh, triangulation_);
    dofs_.distribute_dofs(fe_);
  }

  Discretisation fill() const override { return SpaceFiller<dim>(problem_, dofs_, mapping_, shared).run(); }

  bool adapt(const std::vector<Space::Mark>& marks) override {
    std::size_t index = 0;
    for (const auto& cell : triangulation_.active_cell_iterators()) {
      const Space::Mark mark = marks.at(index++);
      if (mark == Space::Mark::halve) cell->set_refine_flag();
      if (mark == Space::Mark::join && cell->level() > 0) cell->set_coarsen_flag();
    }
    triangulation_.prepare_coarsening_and_refinement();
    if (!any_flag()) return false;
    triangulation_.execute_coarsening_and_refinement();
    dofs_.distribute_dofs(fe_);
    return true;
  }

 private:
  static constexpr bool shared = !std::is_same_v<Tria, dealii::Triangulation<dim>>;

  bool any_flag() const {
    for (const auto& cell : triangulation_.active_cell_iterators()) {
      if (cell->refine_flag_set() || cell->coarsen_flag_set()) return true;
    }
    return false;
  }

  const RichardsProblem& problem_;
  Tria triangulation_;
  dealii::FE_Q<dim> fe_;
  dealii::MappingQ<dim> mapping_;
  dealii::DoFHandler<dim> dofs_;
};

template <int dim>
std::unique_ptr<Space::Triangulated> serial(const RichardsProblem& problem) {
  using Tria = dealii::Triangulation<dim>;
  return std::make_unique<Refinable<dim, Tria>>(problem, Tria::limit_level_difference_at_vertices);
}

template <int dim>
std::unique_ptr<Space::Triangulated> divided(const RichardsProblem& problem) {
  using Tria = dealii::parallel::distributed::Triangulation<dim>;
  sc_set_log_defaults(nullptr, nullptr, SC_LP_SILENT);  // p4est tells its steps on stdout else
  return std::make_unique<Refinable<dim, Tria>>(problem, MPI_COMM_WORLD);
}

std::unique_ptr<Space::Triangulated> make(const RichardsProblem& problem, bool shared) {
  dealii::MultithreadInfo::set_thread_limit(1);
  if (shared) return problem.mesh.dim == 2 ? divided<2>(problem) : divided<3>(problem);
  switch (problem.mesh.dim) {
    case 1:
      return serial<1>(problem);
    case 2:
      return serial<2>(problem);
    case 3:
      return serial<3>(problem);
    default:
      throw std::invalid_argument("mesh.dim must be 1, 2 or 3");
  }
}

}  // namespace

Space::Space(const RichardsProblem& problem, bool shared) : triangulated_(make(problem, shared)) {}

Space::~Space() = default;

Discretisation Space::discretisation() const {
  return triangulated_->fill();
}

bool Space::adapt(const std::vector<Mark>& marks) {
  return triangulated_->adapt(marks);
}

Discretisation discretise(const RichardsProblem& problem) {
  return Space(problem).discretisation();
}

}  // namespace wetfront::fem_reference
