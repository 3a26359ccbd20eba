#include "mpm/seepage/seepage.h"

#include "mpm/grid/cell_values.h"
#include "mpm/grid/soils_of_cells.h"
#include "mpm/record/water_ledger.h"

#include <algorithm>
#include <limits>

namespace wetfront::mpm {

template <int dim>
void Seepage<dim>::add_point_update(StagePlan<dim>& plan) {
  const Column &volume = plan.require_on_points("volume"), &value = plan.require_on_points("shape value");
  Column& ledger = plan.require_on_run("water ledger");
  const auto clear = [&ledger] { ledger[ledger_stored_points][0] = 0; };
  plan.add(Phase::saturation, "clear point sums", clear);
  plan.at_begin(clear);
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const int region = static_cast<int>(r);
    const auto update = [this, &volume, &value, &ledger, content = soils_[r].content,
                         porosity = plan.problem.soils[r].porosity](const Block& block) {
      constexpr int n = cell_nodes<dim>;
      std::array<double, n> pressure{}, held{};
      for (int i = 0; i < n; ++i) {
        pressure[i] = (*columns_.pressure)[0][block.nodes[i]];
        held[i] = content.at(pressure[i]).value;
      }
      double water = 0;
      for (std::size_t q = block.first; q < block.first + block.count; ++q) {
        double p = 0, pores_filled = 0;
        for (int i = 0; i < n; ++i) {
          p += value[i][q] * pressure[i];
          pores_filled += value[i][q] * held[i];
        }
        (*columns_.point_pressure)[0][q] = p;
        (*columns_.point_saturation)[0][q] = content.saturation(p);
        water += volume[0][q] * porosity * pores_filled;
      }
      ledger[ledger_stored_points][0] += water;
    };
    const std::string name = "points from nodes [" + plan.problem.soils[r].name + "]";
    plan.add_over_blocks(Phase::saturation, name, region, update);
    plan.at_begin([&points = plan.fields.points, region, update] {
      for (const Block& block : points.blocks(region)) update(block);
    });
  }
}

template <int dim>
void Seepage<dim>::add_moving_points(StagePlan<dim>& plan) {
  Column& ledger = plan.require_on_run("water ledger");
  const auto add_up = [this, &ledger] { ledger[ledger_stored_points][0] = skeleton_->carried().total(); };
  plan.add(Phase::saturation, "points take what nodes gained", [this, add_up] {
    skeleton_->end_step();
    add_up();
  });
  plan.at_begin([this, add_up] {
    skeleton_->begin_stage();
    add_up();
  });
}

template <int dim>
void Seepage<dim>::add_ledger(StagePlan<dim>& plan) {
  Column& ledger = plan.provide_on_run(water_ledger_spec());
  Column& outflow = plan.require_on_nodes("outflow");
  const auto write = [this, &ledger, &outflow] {
    // Points that move carry their water: what they hold is what there is.
    ledger[ledger_stored][0] = skeleton_ != nullptr ? skeleton_->carried().total() : columns_.stored->sum();
    ledger[ledger_outflow][0] = outflow.sum();
  };
  plan.add(Phase::carry, "water ledger", write);
  // The first nodal storage of the stage: W(p) of the pressures it starts from.
  plan.at_begin([this, write] {
    std::ranges::copy(columns_.pressure->values(), water_->trial->values().begin());
    water_->stored->fill(0);
    for (Kernel* term : water_->terms)
      if (term->name().starts_with("storage")) term->run();
    std::ranges::copy(water_->stored->values(), columns_.stored->values().begin());
    write();
  });
}

template <int dim>
void Seepage<dim>::add_output(StagePlan<dim>& plan) {
  plan.at_output([this, &plan](meshes::Snapshot& out) {
    const auto& grid = plan.fields.grid;
    const double* p = (*columns_.pressure)[0];
    out.node_pressure.assign(p, p + grid.node_count());
    out.node_saturation.assign(grid.node_count(), std::numeric_limits<double>::quiet_NaN());
    const auto& points = plan.fields.points;
    out.cell_pressure = cell_values<dim>(grid, p, [&points](std::size_t c) { return main_soil(points, c); });
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      const int main = main_soil(points, cell);
      const SoilContent& content = soils_[static_cast<std::size_t>(main >= 0 ? main : grid.region(cell))].content;
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const int node = grid.cell_nodes_of(cell)[i];
        out.node_saturation[static_cast<std::size_t>(node)] = content.saturation(p[node]);
      }
      out.cell_saturation.push_back(content.saturation(out.cell_pressure[cell]));
    }
    out.points.pressure = plan.fields.points.in_order(*columns_.point_pressure);
    out.points.saturation = plan.fields.points.in_order(*columns_.point_saturation);
  });
}

template void Seepage<2>::add_point_update(StagePlan<2>&);
template void Seepage<3>::add_point_update(StagePlan<3>&);
template void Seepage<2>::add_moving_points(StagePlan<2>&);
template void Seepage<3>::add_moving_points(StagePlan<3>&);
template void Seepage<2>::add_ledger(StagePlan<2>&);
template void Seepage<3>::add_ledger(StagePlan<3>&);
template void Seepage<2>::add_output(StagePlan<2>&);
template void Seepage<3>::add_output(StagePlan<3>&);

}  // namespace wetfront::mpm
