#include "fem_reference/recorder.h"

#include <algorithm>

namespace wetfront::fem_reference {

Recorder::Recorder(const RichardsProblem& problem) : problem_(problem), totals_(problem) {
  for (const Gauge& gauge : problem.gauges) history_.gauges.push_back({gauge.name, gauge.position, {}, {}, {}});
}

void Recorder::attach(const FlowOperator& flow, const Boundary& boundary, const State& state) {
  flow_ = &flow;
  boundary_ = &boundary;
  totals_.attach(boundary, state);
  if (mesh_) return;
  mesh_.emplace(problem_, flow.space());
  history_.mesh = mesh_->mesh();
  if (!problem_.adaptivity) return;
  catchment_ = mesh_->catchment();
  rain_asked_.assign(history_.mesh.node_count(), 0.0);
  rain_run_off_.assign(history_.mesh.node_count(), 0.0);
}

void Recorder::detach(const State& state) {
  totals_.advance(state);
  collect_rain(state);
}

double Recorder::head_at(const State& state, int cell, const double* shape) const {
  const Discretisation& space = flow_->space();
  double head = 0;
  for (int a = 0; a < space.dofs_per_cell; ++a) head += shape[a] * state.head[space.dofs_of(cell)[a]];
  return head;
}

void Recorder::record_step(const State& state) {
  totals_.advance(state);
  meshes::LedgerRow row = totals_.row();
  row.time = state.time;
  row.stored = flow_->stored(state.water);
  history_.ledger.push_back(row);
  totals_.append_to(history_.sides);

  const Discretisation& space = flow_->space();
  for (std::size_t g = 0; g < history_.gauges.size(); ++g) {
    const Place& place = space.gauges[g];
    const double head = head_at(state, place.cell, place.shape.data());
    meshes::Gauge& gauge = history_.gauges[g];
    gauge.time.push_back(state.time);
    gauge.pressure.push_back(problem_.unit_weight * head);
    gauge.saturation.push_back(flow_->laws()[space.cell_soil[place.cell]].saturation(head));
  }
}

void Recorder::record_snapshot(const State& state) {
  const Discretisation& space = flow_->space();
  const std::vector<SoilLaw>& laws = flow_->laws();
  meshes::Snapshot snapshot;
  snapshot.time = state.time;
  snapshot.stage = "infiltration";
  const std::vector<double> node_head = mesh_->at_nodes(space, state.head);
  // Where soils meet, a node holds the water of all of them in the pores of all of them.
  std::vector<double> water(node_head.size(), 0.0), pores(node_head.size(), 0.0);
  for (const RecordMesh::NodeShare& share : mesh_->shares()) {
    water[share.node] += share.volume * laws[share.soil].water_content(node_head[share.node]).value;
    pores[share.node] += share.volume * laws[share.soil].porosity();
  }
  for (std::size_t i = 0; i < node_head.size(); ++i) {
    snapshot.node_pressure.push_back(problem_.unit_weight * node_head[i]);
    snapshot.node_saturation.push_back(water[i] / pores[i]);
  }
  const std::vector<double> cell_head = mesh_->at_cells(space, state.head);
  for (std::size_t c = 0; c < cell_head.size(); ++c) {
    snapshot.cell_pressure.push_back(problem_.unit_weight * cell_head[c]);
    snapshot.cell_saturation.push_back(laws[history_.mesh.region[c]].saturation(cell_head[c]));
  }
  history_.snapshots.push_back(std::move(snapshot));
}

// Rain and run-off per area are fields of the element; a node of the record takes them times the area it catches on,
// and the sum stays: the coarse shape functions are sums of the fine ones.
void Recorder::collect_rain(const State& state) {
  const Discretisation& space = flow_->space();
  std::vector<double> asked(space.dof_count, 0.0), run_off(space.dof_count, 0.0);
  const std::vector<HeldDof>& held = boundary_->held();
  for (std::size_t h = 0; h < held.size(); ++h) {
    double area = 0;
    for (const HeldDof::Catchment& catchment : held[h].catchment) area += catchment.area;
    if (area == 0) continue;
    asked[held[h].dof] = boundary_->asked(held[h], state.time) / area;
    run_off[held[h].dof] = state.totals[h] / area;
  }
  const std::vector<double> asked_there = mesh_->at_nodes(space, asked);
  const std::vector<double> run_off_there = mesh_->at_nodes(space, run_off);
  for (std::size_t i = 0; i < catchment_.size(); ++i) {
    rain_asked_[i] += catchment_[i] * asked_there[i];
    rain_run_off_[i] += catchment_[i] * run_off_there[i];
  }
}

void Recorder::collect_rain_by_dof(const State& state) {
  const std::vector<int>& node_dof = flow_->space().node_dof;
  const std::vector<HeldDof>& held = boundary_->held();
  for (std::size_t h = 0; h < held.size(); ++h) {
    if (held[h].catchment.empty()) continue;
    const auto node = std::find(node_dof.begin(), node_dof.end(), held[h].dof);
    meshes::NodeRain rain;
    rain.node = node == node_dof.end() ? -1 : static_cast<int>(node - node_dof.begin());  // -1: between nodes
    rain.position = flow_->space().position[held[h].dof];
    rain.asked = boundary_->asked(held[h], state.time);
    rain.run_off = state.totals[h];
    rain.imposed = rain.asked - rain.run_off;
    history_.rain_by_node.push_back(rain);
  }
}

void Recorder::count_sides() {
  for (const meshes::SideLedger& side : history_.sides) {
    if (side.condition == "source") history_.counters["source"] = -side.outflow.back();
    if (side.side.empty()) continue;
    history_.counters["outflow through " + side.side] = side.outflow.back();
    if (side.demanded.back() == 0) continue;
    history_.counters["evaporated through " + side.side] = side.evaporated.back();
    history_.counters["evaporation asked of " + side.side] = side.demanded.back();
  }
}

meshes::FieldHistory Recorder::finish(const State& state) {
  count_sides();
  if (!problem_.adaptivity) {
    collect_rain_by_dof(state);
    return std::move(history_);
  }
  collect_rain(state);
  for (std::size_t i = 0; i < catchment_.size(); ++i) {
    if (catchment_[i] == 0) continue;
    history_.rain_by_node.push_back({static_cast<int>(i), history_.mesh.nodes[i], rain_asked_[i],
                                     rain_asked_[i] - rain_run_off_[i], rain_run_off_[i]});
  }
  return std::move(history_);
}

}  // namespace wetfront::fem_reference
