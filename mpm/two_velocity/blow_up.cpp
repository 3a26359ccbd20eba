#include "mpm/two_velocity/blow_up.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wetfront::mpm {

namespace {

enum StreakComponent { reversals, largest_at_first };

/// A millionth of the flux that gravity drives through the most permeable soil.
template <int dim>
double smallest_flux(const Problem<dim>& problem) {
  constexpr double gravity = 9.81;  // a scale only: the scene may have none
  double most = 0;
  for (const Soil& soil : problem.soils)
    most = std::max(most, soil.intrinsic_permeability / problem.water->viscosity * problem.water->density * gravity);
  return 1e-6 * most;
}

}  // namespace

template <int dim>
std::string place_text(const Vector<dim>& x) {
  std::ostringstream text;
  for (int a = 0; a < dim; ++a) text << (a == 0 ? "(" : ", ") << x[a];
  text << ") m";
  return text.str();
}

template <int dim>
std::string step_against_limit(const StagePlan<dim>& plan, const TwoVelocityWater<dim>& water) {
  const double limit = *std::min_element(water.limit_of_soil.begin(), water.limit_of_soil.end());
  std::ostringstream text;
  text << "; dt = " << plan.clock.dt << " s is " << plan.clock.dt / limit << " times the step limit of " << limit
       << " s. Use a smaller step_safety (now " << plan.stage.step_safety << ")";
  return text.str();
}

template <int dim>
BlowUp<dim>::BlowUp(StagePlan<dim>& plan, const TwoVelocityWater<dim>& water)
    : plan_(plan),
      water_(water),
      before_(plan.provide_on_nodes({"Darcy flux before", "w", "m/s", dim, Lifetime::step})),
      change_(plan.provide_on_nodes({"change of Darcy flux", "dw", "m/s", dim})),
      streak_(plan.provide_on_nodes({"streak of reversals", "-", "-", 2})),
      shortest_(plan.problem.soils.front().elastic ? shortest_in_motion : shortest_at_rest),
      floor_(std::pow(smallest_flux(plan.problem), 2)) {}

template <int dim>
void BlowUp<dim>::remember() {
  std::ranges::copy(water_.flux->values(), before_.values().begin());
}

template <int dim>
void BlowUp<dim>::examine() {
  double largest = 0;  // square of the largest change
  for (std::size_t i = 0; i < before_.size(); ++i) {
    double along = 0, square = 0, square_before = 0;
    for (int a = 0; a < dim; ++a) {
      const double last = change_[a][i], now = (*water_.flux)[a][i] - before_[a][i];
      along += last * now;
      square += now * now;
      square_before += last * last;
      change_[a][i] = now;
    }
    largest = std::max(largest, square);
    // Opposed within 60 degrees.
    streak_[reversals][i] = along < -0.5 * std::sqrt(square * square_before) ? streak_[reversals][i] + 1 : 0;
    if (streak_[reversals][i] >= shortest_ && square > std::max(growth * growth * streak_[largest_at_first][i], floor_))
      throw StepFailed(report(i, std::sqrt(square)));
  }
  // A body in motion is quiet at times and struck at others: there a node keeps the largest change that it has known.
  const bool moves = shortest_ == shortest_in_motion;
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (streak_[reversals][i] == 0)
      streak_[largest_at_first][i] = moves ? std::max(largest, streak_[largest_at_first][i]) : largest;
}

template <int dim>
std::string BlowUp<dim>::report(std::size_t node, double size) const {
  std::ostringstream text;
  text << "the two-velocity scheme has blown up: Darcy's flux at node " << node << " "
       << place_text<dim>(plan_.fields.grid.node(static_cast<int>(node)))
       << " has changed to and fro in each of the last " << streak_[reversals][node] << " steps, in the end by " << size
       << " m/s, " << size / std::sqrt(streak_[largest_at_first][node]) << " times the largest change anywhere before"
       << step_against_limit<dim>(plan_, water_);
  return text.str();
}

template std::string place_text<2>(const Vector<2>&);
template std::string place_text<3>(const Vector<3>&);
template std::string step_against_limit(const StagePlan<2>&, const TwoVelocityWater<2>&);
template std::string step_against_limit(const StagePlan<3>&, const TwoVelocityWater<3>&);
template class BlowUp<2>;
template class BlowUp<3>;

}  // namespace wetfront::mpm
