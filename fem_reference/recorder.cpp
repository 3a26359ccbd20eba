#include "fem_reference/recorder.h"

#include <algorithm>

namespace wetfront::fem_reference {

Recorder::Recorder(const RichardsProblem& problem, const FlowOperator& flow, const Boundary& boundary)
    : problem_(problem), flow_(flow), boundary_(boundary) {
  history_.mesh = problem.mesh;
  for (const Gauge& gauge : problem.gauges) history_.gauges.push_back({gauge.name, gauge.position, {}, {}, {}});
}

double Recorder::head_at(const State& state, int cell, const double* shape) const {
  const int n = flow_.space().dofs_per_cell;
  double head = 0;
  for (int a = 0; a < n; ++a) {
    head += shape[a] * state.head[flow_.space().cell_dofs[static_cast<std::size_t>(cell) * n + a]];
  }
  return head;
}

double Recorder::evaporated(const State& state, std::size_t h) const {
  if (!boundary_.has_demand()) return 0;
  const std::size_t unmet = boundary_.held().size() + boundary_.condition_count();
  return boundary_.demanded(boundary_.held()[h], state.time) - state.totals[unmet + h];
}

void Recorder::record_step(const State& state) {
  meshes::LedgerRow row;
  row.time = state.time;
  row.stored = flow_.stored(state.water);
  const std::vector<HeldDof>& held = boundary_.held();
  for (std::size_t h = 0; h < held.size(); ++h) {
    row.rain_asked += boundary_.asked(held[h], state.time);
    row.run_off += state.totals[h];
    row.outflow += evaporated(state, h);
  }
  row.infiltrated = row.rain_asked - row.run_off;
  for (int c = 0; c < boundary_.condition_count(); ++c) row.outflow += state.totals[held.size() + c];
  if (flow_.has_source()) row.outflow -= state.totals.back();  // water that came in other than as rain
  history_.ledger.push_back(row);

  for (std::size_t g = 0; g < history_.gauges.size(); ++g) {
    const Place& place = flow_.space().gauges[g];
    const double head = head_at(state, place.cell, place.shape.data());
    meshes::Gauge& gauge = history_.gauges[g];
    gauge.time.push_back(state.time);
    gauge.pressure.push_back(problem_.unit_weight * head);
    gauge.saturation.push_back(flow_.laws()[flow_.space().cell_soil[place.cell]].saturation(head));
  }
}

void Recorder::record_snapshot(const State& state) {
  const Discretisation& space = flow_.space();
  meshes::Snapshot snapshot;
  snapshot.time = state.time;
  snapshot.stage = "infiltration";
  // Where soils meet, a node holds the water of all of them in the pores of all of them.
  std::vector<double> water(space.dof_count, 0.0), pores(space.dof_count, 0.0);
  for (const StorageShare& share : space.storage) {
    const SoilLaw& law = flow_.laws()[share.soil];
    water[share.dof] += share.volume * law.water_content(state.head[share.dof]).value;
    pores[share.dof] += share.volume * law.porosity();
  }
  for (int dof : space.node_dof) {
    snapshot.node_pressure.push_back(problem_.unit_weight * state.head[dof]);
    snapshot.node_saturation.push_back(water[dof] / pores[dof]);
  }
  for (int cell = 0; cell < space.cell_count; ++cell) {
    const double head = head_at(state, cell, space.centre_shape_of(cell));
    snapshot.cell_pressure.push_back(problem_.unit_weight * head);
    snapshot.cell_saturation.push_back(flow_.laws()[space.cell_soil[cell]].saturation(head));
  }
  history_.snapshots.push_back(std::move(snapshot));
}

meshes::FieldHistory Recorder::finish(const State& state, const StageKernel& kernel, const TimeIntegrator& integrator,
                                      double cpu_seconds) {
  const std::vector<HeldDof>& held = boundary_.held();
  const std::vector<int>& node_dof = flow_.space().node_dof;
  for (std::size_t h = 0; h < held.size(); ++h) {
    if (held[h].catchment.empty()) continue;
    const auto node = std::find(node_dof.begin(), node_dof.end(), held[h].dof);
    meshes::NodeRain rain;
    rain.node = node == node_dof.end() ? -1 : static_cast<int>(node - node_dof.begin());  // -1: between nodes
    rain.position = flow_.space().position[held[h].dof];
    rain.asked = boundary_.asked(held[h], state.time);
    rain.run_off = state.totals[h];
    rain.imposed = rain.asked - rain.run_off;
    history_.rain_by_node.push_back(rain);
  }
  for (int c = 0; c < boundary_.condition_count(); ++c) {
    history_.counters["outflow through " + boundary_.side_name(c)] = state.totals[held.size() + c];
  }
  if (flow_.has_source()) history_.counters["source"] = state.totals.back();
  for (std::size_t h = 0; h < held.size() && boundary_.has_demand(); ++h) {
    const std::string& side = boundary_.side_name(held[h].condition);
    history_.counters["evaporated through " + side] += evaporated(state, h);
    history_.counters["evaporation asked of " + side] += boundary_.demanded(held[h], state.time);
  }
  integrator.report(history_.counters);
  history_.counters["Newton iterations"] = static_cast<double>(kernel.iterations);
  history_.counters["residual evaluations"] = static_cast<double>(kernel.evaluations);
  history_.counters["nonlinear solves"] = static_cast<double>(kernel.solves);
  history_.counters["failed nonlinear solves"] = static_cast<double>(kernel.failed_solves);
  history_.counters["degrees of freedom"] = flow_.space().dof_count;
  history_.solver = "fem: " + integrator.name() + ", Q" + std::to_string(problem_.degree) + " lumped";
  history_.cpu_seconds = cpu_seconds;
  const Cost& evaluation = flow_.evaluation_cost;
  const Cost& assembly = flow_.assembly_cost;
  const Cost& linear = kernel.linear_solve_cost;
  history_.cost = {
      {"stage", "residual", evaluation.seconds, evaluation.calls},
      {"stage", "Jacobian", assembly.seconds, assembly.calls},
      {"stage", "linear solve", linear.seconds, linear.calls},
      {"time", "integrator, recording, set-up", cpu_seconds - evaluation.seconds - assembly.seconds - linear.seconds,
       static_cast<long>(history_.counters["steps"])},
  };
  return std::move(history_);
}

}  // namespace wetfront::fem_reference
