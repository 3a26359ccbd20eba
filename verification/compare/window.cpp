#include "verification/compare/window.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace wetfront::verification {
namespace {

using Key = std::array<long long, 3>;

/// Meshes of one geometry agree to 1e-12 m in their nodes.
Key key_of(const meshes::Point& x) {
  constexpr double apart = 1e-6;  // m
  return {std::llround(x[0] / apart), std::llround(x[1] / apart), std::llround(x[2] / apart)};
}

/// Index into `from` of every place of `places`.
std::vector<std::size_t> found_in(const std::vector<meshes::Point>& from, const std::vector<meshes::Point>& places) {
  std::map<Key, std::size_t> index;
  for (std::size_t i = 0; i < from.size(); ++i) index[key_of(from[i])] = i;
  std::vector<std::size_t> found;
  for (const meshes::Point& place : places) {
    const auto at = index.find(key_of(place));
    if (at == index.end()) throw std::logic_error("the ground is no part of the candidate's mesh");
    found.push_back(at->second);
  }
  return found;
}

std::vector<meshes::Point> centres(const meshes::Mesh& mesh) {
  std::vector<meshes::Point> places;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) places.push_back(mesh.cell_centre(c));
  return places;
}

/// Times up to this one count as until `time`.
double last_of(double time) {
  return time * (1 + 1e-12);
}

template <class Value>
void pick(std::vector<Value>& values, const std::vector<std::size_t>& index) {
  if (values.empty()) return;
  std::vector<Value> out;
  for (const std::size_t i : index) out.push_back(values[i]);
  values = std::move(out);
}

}  // namespace

double failure_time(const mpm::BodyRecord& body) {
  for (const mpm::StageSpan& stage : body.stages)
    if (stage.ended_by == "failure") return stage.end;
  return std::numeric_limits<double>::infinity();
}

std::vector<meshes::LedgerRow> cut_at(std::vector<meshes::LedgerRow> ledger, double time) {
  ledger.erase(std::ranges::upper_bound(ledger, last_of(time), {}, &meshes::LedgerRow::time), ledger.end());
  return ledger;
}

void cut_at(meshes::FieldHistory& history, double time) {
  if (std::isinf(time)) return;
  const double last = last_of(time);
  history.ledger = cut_at(std::move(history.ledger), time);
  const std::size_t rows = history.ledger.size();
  for (meshes::SideLedger& side : history.sides)
    for (auto* column : {&side.asked, &side.run_off, &side.outflow, &side.evaporated, &side.demanded})
      column->resize(std::min(column->size(), rows));
  for (meshes::Gauge& gauge : history.gauges) {
    const auto count = static_cast<std::size_t>(std::ranges::upper_bound(gauge.time, last) - gauge.time.begin());
    for (auto* column : {&gauge.time, &gauge.pressure, &gauge.saturation}) column->resize(count);
  }
  std::erase_if(history.snapshots, [last](const meshes::Snapshot& one) { return one.time > last; });
}

Histories cut_at(const Histories& histories, double time) {
  Histories out = histories;
  for (auto* history : {&out.candidate, &out.reference, &out.finer, &out.tighter}) cut_at(*history, time);
  if (out.coarser) cut_at(*out.coarser, time);
  return out;
}

Timeline cut_at(const Timeline& timeline, double time) {
  if (std::isinf(time)) return timeline;
  Timeline out = timeline;
  std::erase_if(out.comparison_times, [time](double t) { return t > time; });
  std::erase_if(out.stage_end, [time](double t) { return t >= time; });
  out.stage_end.push_back(time);
  return out;
}

meshes::FieldHistory on_ground(const meshes::FieldHistory& history, const meshes::Mesh& ground) {
  const auto nodes = found_in(history.mesh.nodes, ground.nodes),
             cells = found_in(centres(history.mesh), centres(ground));
  meshes::FieldHistory out = history;
  out.mesh = ground;
  for (meshes::Snapshot& snapshot : out.snapshots) {
    pick(snapshot.node_pressure, nodes);
    pick(snapshot.node_saturation, nodes);
    pick(snapshot.node_displacement, nodes);
    pick(snapshot.cell_pressure, cells);
    pick(snapshot.cell_saturation, cells);
  }
  std::map<std::size_t, int> number;
  for (std::size_t i = 0; i < nodes.size(); ++i) number[nodes[i]] = static_cast<int>(i);
  std::erase_if(out.rain_by_node, [&](const auto& rain) { return !number.count(static_cast<std::size_t>(rain.node)); });
  for (auto& rain : out.rain_by_node) rain.node = number[static_cast<std::size_t>(rain.node)];
  return out;
}

}  // namespace wetfront::verification
