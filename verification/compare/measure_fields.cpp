#include "verification/compare/measuring.h"
#include "verification/compare/profile.h"
#include "verification/scene/weather.h"
#include "verification/translate/initial_pressure.h"

#include <algorithm>
#include <map>
#include <stdexcept>

/// Fields at the comparison times: cells, nodes, front, pressure at the rained surface.
namespace wetfront::verification {

void Measuring::fields() {
  const auto weight = cell_weights(candidate_.mesh, reference_.mesh);
  if (!(scene_.mpm.surface_in_cell < 1) && std::ranges::find(weight, 0.0) != weight.end())
    throw std::logic_error("the MPM has cells outside the reference's mesh, though its surface follows cells");
  const auto candidate = cell_profiles(candidate_);
  std::map<const meshes::FieldHistory*, std::vector<Profile>> profiles;
  read_reference([&](const meshes::FieldHistory& history) {
    profiles[&history] = profiles_at_cells(history, candidate_);
    return std::vector<double>{};
  });
  const auto [low, high] = std::ranges::minmax(initial_pressure(scene_, candidate_.mesh));
  const double range = high - low;
  const bool one_mesh = static_cast<std::size_t>(std::ranges::count_if(weight, [](double w) { return w > 0; })) ==
                        reference_.mesh.cell_count();
  const Distance linf = [&](const auto& a, const auto& b) { return relative_linf(a, b, weight); };
  const Distance l2 = [&](const auto& a, const auto& b) { return relative_l2(a, b, weight); };
  const Distance of_range = [&](const auto& a, const auto& b) { return root_mean_square(a, b, weight) / range; };
  for (std::size_t t = 0; t < common_times(); ++t) {
    const int index = static_cast<int>(t);
    const auto values = [&](std::vector<double> Profile::*part) {
      return Read{candidate[t].*part,
                  read_reference([&](const auto& history) { return profiles.at(&history)[t].*part; })};
    };
    const Read pressure = values(&Profile::pressure), saturation = values(&Profile::saturation);
    add({"pressure_l2", "relative L2 of pore pressure" + at_time(t), index}, pressure, l2);
    add({"pressure_linf", "largest difference of pore pressure" + at_time(t), index}, pressure, linf);
    add({"saturation_l2", "relative L2 of saturation" + at_time(t), index}, saturation, l2);
    add({"saturation_linf", "largest difference of saturation" + at_time(t), index}, saturation, linf);
    if (range > 0) {
      add({"pressure_l2_range", "rms difference of pore pressure over the initial range" + at_time(t), index}, pressure,
          of_range);
      // Two codes on one mesh share its error: no bound of the reference belongs to their difference.
      if (one_mesh)
        add({"pressure_one_mesh",
             "the same, of two codes on one mesh" + at_time(t),
             index,
             "",
             of_range(pressure.candidate, pressure.reference.reference),
             {},
             ""});
      add({"pressure_finer",
           "the same, against the reference on half the cell size" + at_time(t),
           index,
           "",
           of_range(pressure.candidate, pressure.reference.finer),
           {},
           ""});
    }
    front({"front_position", "elevation of the wetting front" + at_time(t), index}, saturation);
  }
}

void Measuring::front(const Label& label, const Read& saturation) {
  if (!std::holds_alternative<Column>(scene_.geometry.shape)) return;
  const meshes::Mesh& mesh = candidate_.mesh;
  const auto weight = cell_weights(mesh, reference_.mesh);
  std::vector<std::size_t> cells;
  std::vector<double> elevation;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    if (weight[c] == 0) continue;
    cells.push_back(c);
    elevation.push_back(mesh.cell_centre(c)[meshes::up_axis(mesh.dim)]);
  }
  const auto front_of = [&](const std::vector<double>& s) {
    std::vector<double> compared;
    for (const std::size_t c : cells) compared.push_back(s[c]);
    return std::vector<double>{front_elevation(compared, elevation)};
  };
  const ReferenceValues& family = saturation.reference;
  Read at{front_of(saturation.candidate),
          {front_of(family.reference), {}, front_of(family.finer), front_of(family.tighter)}};
  if (family.coarser) at.reference.coarser = front_of(*family.coarser);
  add(label, at, of_numbers(absolute_difference),
      fmt::format("candidate {} m, reference {} m", value_text(at.candidate[0]),
                  value_text(at.reference.reference[0])));
}

/// The nodes themselves, for schemes whose unknowns live there. Nodes are weighted alike.
void Measuring::nodes() {
  std::map<const meshes::FieldHistory*, std::vector<std::vector<double>>> pressures;
  read_reference([&](const meshes::FieldHistory& history) {
    pressures[&history] = pressure_at_nodes(history, candidate_.mesh);
    return std::vector<double>{};
  });
  const std::vector<double> alike = node_weights(candidate_.mesh, reference_.mesh);
  for (std::size_t t = 0; t < common_times(); ++t) {
    if (candidate_.snapshots[t].cells_hold_averages) continue;  // its unknowns are in the cells
    add({"pressure_l2_nodes", "relative L2 of pore pressure at the nodes" + at_time(t), static_cast<int>(t)},
        {candidate_.snapshots[t].node_pressure,
         read_reference([&](const auto& history) { return pressures.at(&history)[t]; })},
        [&](const auto& a, const auto& b) { return relative_l2(a, b, alike); });
  }
}

/// Places of a rained surface in the candidate's mesh: the nodes of the side, or where the ground lies below them.
std::vector<meshes::Evaluator::Weights> Measuring::surface_places(const std::string& side) const {
  const meshes::Mesh& mesh = candidate_.mesh;
  std::vector<meshes::Evaluator::Weights> places;
  const meshes::Evaluator evaluate(mesh);
  for (const int node : mesh.side(side).faces) {
    if (!(scene_.mpm.surface_in_cell < 1) || side != "top")
      places.push_back({{node}, {1.0}});
    else
      places.push_back(evaluate.weights({mesh.nodes[node][0], surface_at(scene_.geometry, mesh.nodes[node][0]), 0}));
  }
  return places;
}

void Measuring::overshoot() {
  if (scene_.rains.empty()) return;
  double highest = 0;
  for (const Rain& rain : scene_.rains) {
    if (under_water(scene_, rain.side)) continue;
    for (const meshes::Evaluator::Weights& place : surface_places(rain.side))
      for (const meshes::Snapshot& snapshot : candidate_.snapshots) {
        double pressure = 0;
        for (std::size_t i = 0; i < place.node.size(); ++i)
          pressure += place.weight[i] * snapshot.node_pressure[place.node[i]];
        highest = std::max(highest, pressure);
      }
  }
  add({"overshoot", "largest pressure above zero at the rained surface [Pa]", -1, "", highest, {}, ""});
}

}  // namespace wetfront::verification
