#pragma once

#include "mpm/boundary/surface.h"
#include "mpm/plan/stage_plan.h"
#include "mpm/record/side_totals.h"
#include "mpm/seepage/ties.h"

#include <functional>
#include <memory>
#include <vector>

namespace wetfront::mpm {

/// The nodal water balance of `seepage`, shared by the effect that solves it and those that add terms to it.
///
/// dW_i/dt = R_i for every node i, W_i water stored at the node [m^dim], R_i water flowing to it [m^dim/s].
/// A term is an iterated kernel that reads `trial` and adds to `stored`/`capacity` or to `inflow` and the matrix.
template <int dim>
struct NodalWater {
  struct Held {
    int node;
    double pressure;     ///< Pa
    int condition = -1;  ///< index into Problem::water_boundary: the water goes to its ledger
  };
  /// A rate (of nodes, or of the run) and its integral over time. The integral follows the same BDF weights as W, so
  /// that the ledger closes to the tolerance of Newton's method and not to that of the time integration.
  struct Cumulative {
    Column *rate, *total, *before;
  };

  std::vector<Kernel*> terms;
  std::vector<Kernel*> accepted;  ///< run when a solve is taken, `trial` and `dt` being its own
  std::vector<Held> held;
  Ties ties;
  /// Told before every solve from when until when it goes: what changes in time takes its values there.
  std::vector<std::function<void(double begin, double end)>> before_solve;
  /// Shorten what Newton's method wants at nodes whose balance has a kink on the way from `start` to `trial`.
  std::vector<std::function<void(const std::vector<double>& start, double* trial)>> limits;
  /// Told when points have moved and what depends on their places is made anew.
  std::vector<std::function<void()>> moved;
  /// After the first solve of a step (pass 0) and those that follow: lets the skeleton follow; true when the flow has
  /// to be solved again. Empty: rigid.
  std::function<bool(int pass)> settle;
  std::vector<Cumulative> cumulative;
  std::unique_ptr<SparseSystem> matrix;  ///< of dF/dp; terms add dt-free dR/dp here, `seepage` scales

  Column* trial = nullptr;      ///< p of the iterate [Pa]
  Column* stored = nullptr;     ///< W(p) [m^dim]
  Column* capacity = nullptr;   ///< dW/dp [m^dim/Pa]
  Column* inflow = nullptr;     ///< R(p) [m^dim/s]
  Column* side_rate = nullptr;  ///< d/dt of "side ledger", on the run; null: no condition passes water
  Column* outflow = nullptr;    ///< part of R that leaves through the boundary, > 0 outwards [m^dim/s]
  double dt = 0;                ///< s, of the step that is being tried

  /// Adds dR_i/dp_i of a boundary term.
  void add_slope(int node, double slope) { add_slope(node, node, slope); }
  /// Adds dR_row/dp_column; the two are nodes of one occupied cell.
  void add_slope(int row, int column, double slope) {
    matrix->values()[static_cast<std::size_t>(matrix->slot(row, column))] += slope;
  }

  void add_to_side(int condition, SideEntry entry, double rate) {
    (*side_rate)[side_component(condition, entry)][0] += rate;
  }

  /// The border of the soil, detected when first asked for; all water boundaries of a plan share it.
  Surface<dim>& surface(const StagePlan<dim>& plan) {
    if (surface_ == nullptr) {
      surface_ = std::make_unique<Surface<dim>>(plan.fields.grid, plan.fields.points, plan.problem.mesh);
      surface_->update();
    }
    return *surface_;
  }

  /// Provides the ledger of the sides, once.
  void keep_side_ledger(StagePlan<dim>& plan) {
    if (side_rate != nullptr) return;
    side_rate = &plan.provide_on_run(side_ledger_spec(plan, " rate", Lifetime::step));
    Column& total = plan.provide_on_run(side_ledger_spec(plan, "", Lifetime::carried));
    Column& before = plan.provide_on_run(side_ledger_spec(plan, " before", Lifetime::carried));
    cumulative.push_back({side_rate, &total, &before});
    record_sides(plan, total);
  }

  /// Provides `name rate`, `name` and `name before` on the nodes and has them integrated. Returns the rate.
  Column& cumulate(StagePlan<dim>& plan, const std::string& name, const std::string& symbol) {
    const std::string unit = dim == 2 ? "m2" : "m3";
    Column& rate = plan.provide_on_nodes({name + " rate", "d" + symbol + "/dt", unit + "/s", 1, Lifetime::step});
    Column& total = plan.provide_on_nodes({name, symbol, unit});
    Column& before = plan.provide_on_nodes({name + " before", symbol + "'", unit});
    cumulative.push_back({&rate, &total, &before});
    return rate;
  }

 private:
  std::unique_ptr<Surface<dim>> surface_;
};

}  // namespace wetfront::mpm
