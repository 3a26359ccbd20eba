#include "mpm/boundary/skeleton_boundaries.h"

#include "mpm/boundary/absorbing_side.h"
#include "mpm/boundary/frictional_contact.h"
#include "mpm/boundary/moving_side.h"
#include "mpm/boundary/periodic_skeleton.h"
#include "mpm/boundary/traction.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

template <class Kind, int dim>
std::vector<Kind> all_of_kind(const Problem<dim>& problem) {
  std::vector<Kind> found;
  for (const SkeletonBoundary& boundary : problem.skeleton_boundary)
    if (const auto* one = std::get_if<Kind>(&boundary)) found.push_back(*one);
  return found;
}

/// "traction, frictional contact": the kinds that the problem has.
template <int dim>
std::string names(const Problem<dim>& problem) {
  static const std::array<std::string, 5> kinds{"traction", "moving side", "frictional contact", "absorbing side",
                                                "periodic skeleton"};
  std::array<bool, 5> there{};
  for (const SkeletonBoundary& boundary : problem.skeleton_boundary) there[boundary.index()] = true;
  std::string text;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (there[k]) text += (text.empty() ? "" : ", ") + kinds[k];
  return text;
}

}  // namespace

template <int dim>
SkeletonBoundaries<dim>::SkeletonBoundaries(const Problem<dim>& problem, std::shared_ptr<SkeletonCycle<dim>> cycle)
    : Effect<dim>(names(problem), std::visit([](const auto& b) { return b.origin; }, problem.skeleton_boundary.at(0)),
                  "Coulomb; Lysmer & Kuhlemeyer 1969; mpm/boundary/README.md"),
      cycle_(std::move(cycle)) {}

template <int dim>
void SkeletonBoundaries<dim>::join(StagePlan<dim>& plan) {
  auto& conditions = cycle_->conditions;
  int number = 0;
  for (const Traction& spec : all_of_kind<Traction>(plan.problem))
    conditions.push_back(std::make_unique<TractionCondition<dim>>(plan, spec, number++));
  for (const MovingSide& spec : all_of_kind<MovingSide>(plan.problem))
    conditions.push_back(std::make_unique<MovingCondition<dim>>(plan, *cycle_, spec));
  if (const auto sides = all_of_kind<AbsorbingSide>(plan.problem); !sides.empty())
    conditions.push_back(std::make_unique<AbsorbingCondition<dim>>(plan, *cycle_, sides));
  if (const auto sides = all_of_kind<PeriodicSkeleton>(plan.problem); !sides.empty())
    conditions.push_back(std::make_unique<PeriodicCondition<dim>>(plan, sides));
  if (const auto sides = all_of_kind<FrictionalContact>(plan.problem); !sides.empty())
    conditions.push_back(std::make_unique<ContactCondition<dim>>(plan, *cycle_, sides));
}

template class SkeletonBoundaries<2>;
template class SkeletonBoundaries<3>;

}  // namespace wetfront::mpm
