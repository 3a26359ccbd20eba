#include "fem_reference/record/recorder.h"

#include <algorithm>
#include <limits>

namespace wetfront::fem_reference {

Recorder::Recorder(const RichardsProblem& problem) : problem_(problem), totals_(problem) {
  for (const Gauge& gauge : problem.gauges) history_.gauges.push_back({gauge.name, gauge.position, {}, {}, {}});
}

void Recorder::attach(const FlowOperator& flow, const Boundary& boundary, const State& state) {
  flow_ = &flow;
  boundary_ = &boundary;
  totals_.attach(boundary, flow.space().ranks, state);
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

void Recorder::record_gauges(const State& state) {
  if (history_.gauges.empty()) return;
  const Discretisation& space = flow_->space();
  const std::vector<double> local = space.ranks.with_ghosts(state.head);
  // [gauge][head, saturation]: a gauge lies in cells of one rank, or between two that know the same.
  std::vector<double> values(2 * history_.gauges.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t g = 0; g < history_.gauges.size(); ++g) {
    const auto& [cell, shape] = space.gauges[g];
    if (cell < 0) continue;
    double head = 0;
    for (int a = 0; a < space.dofs_per_cell; ++a) head += shape[a] * local[space.dofs_of(cell)[a]];
    values[2 * g] = head;
    values[2 * g + 1] = flow_->laws()[space.cell_soil[cell]].saturation(head);
  }
  space.ranks.max(values);
  for (std::size_t g = 0; g < history_.gauges.size(); ++g) {
    meshes::Gauge& gauge = history_.gauges[g];
    gauge.time.push_back(state.time);
    gauge.pressure.push_back(problem_.unit_weight * values[2 * g]);
    gauge.saturation.push_back(values[2 * g + 1]);
  }
}

void Recorder::record_step(const State& state) {
  totals_.advance(state);
  meshes::LedgerRow row = totals_.row();
  row.time = state.time;
  row.stored = flow_->stored(state.water);
  history_.ledger.push_back(row);
  totals_.append_to(history_.sides);
  record_gauges(state);
}

void Recorder::record_snapshot(const State& state) {
  const Discretisation& space = flow_->space();
  const std::vector<SoilLaw>& laws = flow_->laws();
  meshes::Snapshot snapshot;
  snapshot.time = state.time;
  snapshot.stage = "infiltration";
  const std::vector<double> local = space.ranks.with_ghosts(state.head);
  const std::vector<double> node_head = mesh_->at_nodes(space, local);
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
  const std::vector<double> cell_head = mesh_->at_cells(space, local);
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
  if (flow_->space().ranks.count() > 1) collect_rain_of_all();
}

// Upwards, as one rank numbers its dofs.
void Recorder::collect_rain_of_all() {
  const int dim = flow_->space().dim;
  constexpr std::size_t width = 6;
  std::vector<double> rows;
  for (const meshes::NodeRain& rain : history_.rain_by_node) {
    rows.insert(rows.end(), {static_cast<double>(rain.node), rain.position[0], rain.position[1], rain.position[2],
                             rain.asked, rain.run_off});
  }
  rows = flow_->space().ranks.gather(rows);
  history_.rain_by_node.clear();
  for (std::size_t i = 0; i < rows.size(); i += width) {
    const double* row = &rows[i];
    history_.rain_by_node.push_back(
        {static_cast<int>(row[0]), {row[1], row[2], row[3]}, row[4], row[4] - row[5], row[5]});
  }
  const auto upwards = [dim](const meshes::NodeRain& a, const meshes::NodeRain& b) {
    for (int axis = dim - 1; axis >= 0; --axis) {
      if (a.position[axis] != b.position[axis]) return a.position[axis] < b.position[axis];
    }
    return false;
  };
  std::sort(history_.rain_by_node.begin(), history_.rain_by_node.end(), upwards);
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
