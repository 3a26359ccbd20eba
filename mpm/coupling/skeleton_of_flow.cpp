#include "mpm/coupling/skeleton_of_flow.h"

#include "mpm/seepage/pore_storage.h"
#include "mpm/skeleton/rigid_skeleton.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
void SkeletonOfFlow<dim>::join(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
                               const std::vector<SoilContent>& contents, std::function<void(bool)> refresh) {
  plan_ = &plan;
  water_ = &water;
  c_ = columns;
  contents_ = &contents;
  refresh_ = std::move(refresh);
  fresh_ = plan.fields.points.columns.find_allocated("water") == nullptr;
  volume_ = &plan.require_on_points("volume");
  value_ = &plan.provide_on_points(shape_value_spec<dim>());
  gradient_ = &plan.provide_on_points(shape_gradient_spec<dim>());
  pore_stress_ = &plan.provide_on_points({"pore stress", "chi p", "Pa"});
  if (std::ranges::any_of(plan.problem.soils, strengthened_by_suction))
    suction_ = &plan.provide_on_points({"suction", "chi s", "Pa"});
  join_own();
}

template <int dim>
void SkeletonOfFlow<dim>::add_storage(int region, const SoilContent& content) const {
  store_in_pores(*water_, c_, region, content);
}

template <int dim>
void SkeletonOfFlow<dim>::refresh_geometry() {
  auto& points = plan_->fields.points;
  std::vector<std::size_t> occupied;
  for (const Block& block : points.blocks()) {
    fill_stencils<dim>(plan_->fields.grid, points, block, *value_, *gradient_);
    occupied.push_back(block.cell);
  }
  measure_cells();
  const bool changed = occupied != occupied_;
  occupied_ = std::move(occupied);
  refresh_(changed);
}

template <int dim>
void SkeletonOfFlow<dim>::press_points(const Column& pressure) {
  for (const Block& block : plan_->fields.points.blocks()) {
    std::array<double, cell_nodes<dim>> push{};
    for (int i = 0; i < cell_nodes<dim>; ++i)
      push[i] = carried_->content_of(block).pore_stress(pressure[0][block.nodes[i]]).value;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double g = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) g += (*value_)[i][q] * push[i];
      (*pore_stress_)[0][q] = g;
      if (suction_ != nullptr) (*suction_)[0][q] = std::max(0.0, -g);
    }
  }
}

template class SkeletonOfFlow<2>;
template class SkeletonOfFlow<3>;

}  // namespace wetfront::mpm
