#include "fem_reference/stage/wetting_limit.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// The head of greatest capacity of a soil, to a few per cent of its suction: it only says where a step may stop.
double bend_of(const SoilLaw& law) {
  double best = 0, bend = -law.air_entry();
  for (double suction = 1e-3; suction < 1e3; suction *= 1.05) {
    const double capacity = law.water_content(-law.air_entry() - suction).slope;
    if (capacity <= best) continue;
    best = capacity;
    bend = -law.air_entry() - suction;
  }
  return bend;
}

}  // namespace

WettingLimit::WettingLimit(const FlowOperator& flow) : flow_(flow) {
  std::vector<double> bends;
  for (const SoilLaw& law : flow.laws()) bends.push_back(bend_of(law));
  nodes_.assign(flow.space().dof_count, {0, -1e300, 0, 0});
  for (const StorageShare& share : flow.space().storage) {
    Node& node = nodes_[share.dof];
    node.bend = std::min(node.bend, bends[share.soil]);
    node.full = std::max(node.full, -flow.laws()[share.soil].air_entry());
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const ValueAndSlope w = flow.storage_at(static_cast<int>(i), nodes_[i].bend);
    nodes_[i].water = w.value;
    nodes_[i].capacity = w.slope;
  }
}

double WettingLimit::moved(int dof, double head, double change) const {
  const Node& node = nodes_[dof];
  if (change < 0) return head > node.bend ? std::max(head + change, node.bend) : head + change;
  constexpr double straight = 1e-3;  // of the suction: W hardly bends
  double next = head + change;
  if (head < node.bend && change > -straight * head) next = wetted(dof, head, change);
  // Just above saturation, so that the next step starts on the saturated side.
  const double beyond = node.full + 1e-3 * (node.full - node.bend);
  return head < node.full ? std::min(next, beyond) : next;
}

double WettingLimit::wetted(int dof, double head, double change) const {
  const Node& node = nodes_[dof];
  const double target = flow_.water()[dof] + flow_.capacity()[dof] * change;
  if (target >= node.water) return std::min(head + change, node.bend + (target - node.water) / node.capacity);
  double dry = head, wet = std::min(head + change, node.bend);
  constexpr int halvings = 12;  // of the logarithm of the suction; this is a guess for the next iteration
  for (int i = 0; i < halvings; ++i) {
    const double middle = wet < 0 ? -std::sqrt(dry * wet) : 0.5 * (dry + wet);
    (flow_.storage_at(dof, middle).value < target ? dry : wet) = middle;
  }
  return wet;
}

}  // namespace wetfront::fem_reference
