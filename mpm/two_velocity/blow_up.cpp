#include "mpm/two_velocity/blow_up.h"

#include "mpm/lanes.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

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

/// At a node, or at four: takes the change of flux there and counts. Gives its square, and where it tells of a blow-up.
template <int dim>
template <class Number>
auto BlowUp<dim>::look_at(std::size_t i) {
  Number along(0.0), square(0.0), square_before(0.0);
  for (int a = 0; a < dim; ++a) {
    const Number last = load<Number>(change_[a] + i),
                 now = load<Number>((*water_.flux)[a] + i) - load<Number>(before_[a] + i);
    along += last * now;
    square += now * now;
    square_before += last * last;
    store(now, change_[a] + i);
  }
  // Opposed within 60 degrees.
  const auto opposed = along < 0.0 && along * along > 0.25 * square * square_before;
  const Number streak = select(opposed, load<Number>(streak_[reversals] + i) + 1.0, Number(0.0));
  store(streak, streak_[reversals] + i);
  const Number most = max(growth * growth * load<Number>(streak_[largest_at_first] + i), Number(floor_));
  return std::pair{square, streak >= static_cast<double>(shortest_) && square > most};
}

template <int dim>
void BlowUp<dim>::examine() {
  const std::size_t nodes = before_.size();
  Lanes largest_of_four(0.0);  // squares of changes
  std::size_t i = 0;
  const auto stop_if = [this](bool struck, std::size_t node, double square) {
    if (struck) throw StepFailed(report(node, std::sqrt(square)));
  };
  for (; i + lane_count <= nodes; i += lane_count) {
    const auto [square, struck] = look_at<Lanes>(i);
    largest_of_four = max(largest_of_four, square);
    if (any(struck))
      for (std::size_t lane = 0; lane < lane_count; ++lane) stop_if(struck[lane], i + lane, square[lane]);
  }
  double largest = std::experimental::hmax(largest_of_four);
  for (; i < nodes; ++i) {
    const auto [square, struck] = look_at<double>(i);
    largest = std::max(largest, square);
    stop_if(struck, i, square);
  }
  // A body in motion is quiet at times and struck at others: there a node keeps the largest change that it has known.
  const bool moves = shortest_ == shortest_in_motion;
  double *most = streak_[largest_at_first], *count = streak_[reversals];
#pragma GCC ivdep
  for (std::size_t node = 0; node < nodes; ++node) {
    const double now = moves ? std::max(largest, most[node]) : largest;
    most[node] = count[node] == 0 ? now : most[node];
  }
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
