#include "verification/compare/outcomes.h"

#include "meshes/evaluate.h"
#include "verification/compare/events.h"
#include "verification/compare/magnitude.h"
#include "verification/compare/profile.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace wetfront::verification {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();

class Outcomes {
 public:
  Outcomes(const Scene& scene, const Timeline& timeline, const meshes::FieldHistory& history,
           const meshes::FieldHistory& cells_of)
      : scene_(scene), timeline_(timeline), history_(history), cells_of_(cells_of) {}

  std::vector<Outcome> all() {
    if (scene_.water) {
      at_times();
      events();
    }
    motion();
    return std::move(found_);
  }

 private:
  void at_times() {
    const auto front = fronts(scene_, history_, cells_of_);
    const double area = ledger_area(scene_, history_.mesh);
    for (std::size_t t = 0; t < timeline_.comparison_times.size(); ++t) {
      const double time = timeline_.comparison_times[t];
      // Without the seconds of a share of filling: those differ between the points of a study.
      const SceneTime& when = scene_.comparison.times[t];
      const std::string at = " at " + (when.of_filling ? fmt::format("{:.4g} % of filling", 100 * when.value)
                                                       : fmt::format("{:.6g} s", time));
      const auto add = [&](const std::string& name, const std::string& what, double value) {
        found_.push_back({name + '@' + std::to_string(t), what + at, "m", value});
      };
      if (std::holds_alternative<Column>(scene_.geometry.shape))
        add("front_position", "elevation of the wetting front", t < front.size() ? front[t] : never);
      const auto column = [&](double meshes::LedgerRow::*part) {
        return history_.ledger.empty() ? never : ledger_at(history_.ledger, part, time) / area;
      };
      add("stored_water", "stored water", column(&meshes::LedgerRow::stored));
      if (!scene_.rains.empty())
        add("cumulative_infiltration", "cumulative infiltration", column(&meshes::LedgerRow::infiltrated));
    }
  }

  void events() {
    if (!scene_.rains.empty())
      found_.push_back({"ponding_time", "time of ponding", "s", ponding_time(history_.ledger)});
    const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
    for (const Probe& probe : scene_.probes) {
      const auto gauge = std::ranges::find(history_.gauges, probe.name, &meshes::Gauge::name);
      const bool there = gauge != history_.gauges.end() && !gauge->pressure.empty();
      const auto add = [&](const std::string& name, const std::string& what, const char* unit, double value) {
        found_.push_back({name + ':' + probe.name, what + " at probe " + probe.name, unit, value});
      };
      add("arrival_time", "p > 0.2 kPa", "s", there ? crossing_time(*gauge, arrival_pressure) : never);
      add("rise_rate", "rise of head", "m/s", there ? rise_rate(*gauge, unit_weight) : never);
      add("highest_pressure", "highest pressure", "Pa", there ? *std::ranges::max_element(gauge->pressure) : never);
    }
  }

  void motion() {
    if (!deforms(scene_)) return;
    double largest = history_.snapshots.empty() ? never : 0;
    if (!history_.snapshots.empty())
      for (const meshes::Point& u : history_.snapshots.back().node_displacement)
        largest = std::max(largest, magnitude(u));
    found_.push_back({"displacement", "largest displacement at the end", "m", largest});
  }

  const Scene& scene_;
  const Timeline& timeline_;
  const meshes::FieldHistory &history_, &cells_of_;
  std::vector<Outcome> found_;
};

}  // namespace

const Outcome* find_outcome(const std::vector<Outcome>& outcomes, const std::string& name) {
  const auto found = std::ranges::find(outcomes, name, &Outcome::name);
  return found == outcomes.end() ? nullptr : &*found;
}

double value_of(const std::vector<Outcome>& outcomes, const std::string& name) {
  const Outcome* found = find_outcome(outcomes, name);
  return found ? found->value : never;
}

namespace {

/// Saturation of another run of a column at the elevations of the candidate's cells, or averaged over them where the
/// candidate's values are averages. The strips of two runs differ in width: only elevations count.
std::vector<double> strip_at_cells(const meshes::FieldHistory& history, const meshes::Snapshot& snapshot,
                                   const meshes::FieldHistory& cells_of, bool averages) {
  const meshes::Mesh &fine = history.mesh, &coarse = cells_of.mesh;
  const meshes::Evaluator evaluate(fine);
  const double middle = fine.cell_centre(0)[0];
  std::vector<double> values;
  for (std::size_t c = 0; c < coarse.cell_count(); ++c) {
    const double y = coarse.cell_centre(c)[1];
    const auto corner = coarse.cell(c);
    const auto [low, high] =
        std::ranges::minmax(corner | std::views::transform([&](int node) { return coarse.nodes[node][1]; }));
    double sum = 0, volume = 0;
    for (std::size_t f = 0; averages && f < fine.cell_count(); ++f) {
      const double centre = fine.cell_centre(f)[1];
      if (centre <= low || centre >= high) continue;
      sum += fine.cell_measure(f) * snapshot.cell_saturation[f];
      volume += fine.cell_measure(f);
    }
    values.push_back(volume > 0 ? sum / volume : evaluate(snapshot.node_saturation, {middle, y, 0}));
  }
  return values;
}

}  // namespace

std::vector<double> fronts(const Scene& scene, const meshes::FieldHistory& history,
                           const meshes::FieldHistory& cells_of) {
  if (!std::holds_alternative<Column>(scene.geometry.shape)) return {};
  const meshes::Mesh& mesh = cells_of.mesh;
  const double surface = surface_at(scene.geometry, 0);
  std::vector<std::size_t> cells;
  std::vector<double> elevation;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const double y = mesh.cell_centre(c)[meshes::up_axis(mesh.dim)];
    if (y > surface) continue;  // the background grid may reach above the ground
    cells.push_back(c);
    elevation.push_back(y);
  }
  // A run on the same cells has values of its own in them, made in the same way.
  const bool own = history.mesh.dim == mesh.dim && history.mesh.cell_count() == mesh.cell_count();
  const bool strips = history.mesh.dim == 2 && mesh.dim == 2;
  const auto profiles = own      ? cell_profiles(history)
                        : strips ? std::vector<Profile>{}
                                 : profiles_at_cells(history, cells_of);
  std::vector<double> found;
  for (std::size_t t = 0; t < std::min(history.snapshots.size(), cells_of.snapshots.size()); ++t) {
    const std::vector<double> all = own || !strips ? profiles[t].saturation
                                                   : strip_at_cells(history, history.snapshots[t], cells_of,
                                                                    cells_of.snapshots[t].cells_hold_averages);
    std::vector<double> saturation;
    for (const std::size_t c : cells) saturation.push_back(all[c]);
    found.push_back(front_elevation(saturation, elevation));
  }
  return found;
}

std::vector<Outcome> outcomes(const Scene& scene, const Timeline& timeline, const meshes::FieldHistory& history,
                              const meshes::FieldHistory& cells_of) {
  return Outcomes(scene, timeline, history, cells_of).all();
}

}  // namespace wetfront::verification
