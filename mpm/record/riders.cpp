#include "mpm/record/riders.h"

#include "mpm/grid/column_vector.h"

#include <limits>

namespace wetfront::mpm {

namespace {

/// Slot of the point that began nearest to a place.
template <int dim>
std::size_t nearest(const StagePlan<dim>& plan, const Column& began, const meshes::Point& place) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t found = 0;
  for (const Block& block : plan.fields.points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      double square = 0;
      for (int a = 0; a < dim; ++a) {
        const double off = began[a][p] - place[static_cast<std::size_t>(a)];
        square += off * off;
      }
      if (square < least) least = square, found = p;
    }
  return found;
}

}  // namespace

template <int dim>
void Riders<dim>::join(StagePlan<dim>& plan) {
  const Column &position = plan.require_on_points("position"), &velocity = plan.require_on_points("velocity");
  const bool fresh = plan.fields.points.columns.find_allocated("initial position") == nullptr;
  // A problem with a body acceleration makes the skeleton remember the same.
  const bool remembered = static_cast<bool>(plan.problem.body_acceleration);
  Column& began = remembered ? plan.require_on_points("initial position")
                             : plan.provide_on_points({"initial position", "X", "m", dim});
  if (fresh && !remembered)
    plan.at_entry([&position, &began] { std::ranges::copy(position.values(), began.values().begin()); });
  plan.at_record([&plan, &position, &velocity, &began](double time, meshes::FieldHistory&) {
    auto& riders = plan.fields.body.riders;
    const auto& asked = plan.problem.riders;
    if (riders.empty())
      for (const Probe& rider : asked)
        riders.push_back({rider.name, point_of<dim>(at<dim>(began, nearest(plan, began, rider.position))), {}, {}, {}});
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const std::size_t slot = nearest(plan, began, asked[k].position);
      Rider& rider = riders[k];
      rider.time.push_back(time);
      rider.place.push_back(point_of<dim>(at<dim>(position, slot)));
      rider.velocity.push_back(point_of<dim>(at<dim>(velocity, slot)));
    }
  });
}

template class Riders<2>;
template class Riders<3>;

}  // namespace wetfront::mpm
