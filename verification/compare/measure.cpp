#include "verification/compare/measure.h"

#include "verification/compare/balance.h"
#include "verification/compare/events.h"
#include "verification/compare/profile.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// |a - b| / |b|, infinity where only one exists, NaN where neither does.
double relative_difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return nothing;
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
  return std::abs(a - b) / std::abs(b);
}

std::string value_text(double value) {
  return std::isnan(value) ? "never" : fmt::format("{:.6g}", value);
}

/// Gathers measurements for one scene.
class Measuring {
 public:
  Measuring(const Scene& scene, const Timeline& timeline, const Histories& histories)
      : scene_(scene),
        timeline_(timeline),
        candidate_(histories.candidate),
        reference_(histories.reference),
        finer_(histories.finer) {}

  std::vector<Measurement> all() {
    fields();
    nodes();
    infiltration();
    events();
    gauges();
    balances();
    overshoot();
    return std::move(found_);
  }

 private:
  void add(Measurement measurement) { found_.push_back(std::move(measurement)); }

  /// An event: one number from each solution.
  void add_event(const std::string& quantity, const std::string& description, const std::string& probe,
                 const std::array<double, 3>& value) {
    const auto [candidate, reference, finer] = value;
    add({quantity, description, -1, probe, relative_difference(candidate, reference),
         relative_difference(finer, reference),
         fmt::format("candidate {}, reference {}", value_text(candidate), value_text(reference))});
  }

  void fields();
  void nodes();
  void front(std::size_t time, const std::array<const Profile*, 3>& profile);
  void infiltration();
  void events();
  void gauges();
  void balances();
  void overshoot();

  double area_of(const meshes::FieldHistory& history) const { return rain_area(scene_, history.mesh); }

  const Scene& scene_;
  const Timeline& timeline_;
  const meshes::FieldHistory &candidate_, &reference_, &finer_;
  std::vector<Measurement> found_;
};

void Measuring::fields() {
  const auto weight = cell_measures(candidate_.mesh);
  const auto candidate = cell_profiles(candidate_);
  const auto reference = profiles_at_cells(reference_, candidate_);
  const auto finer = profiles_at_cells(finer_, candidate_);
  const std::size_t times = std::min({candidate.size(), reference.size(), finer.size()});
  const auto [low, high] = std::ranges::minmax(initial_pressure(scene_, candidate_.mesh));
  const double range = high - low;
  for (std::size_t t = 0; t < times; ++t) {
    const int index = static_cast<int>(t);
    const std::string at = " at " + describe(scene_.comparison.times[t], timeline_.comparison_times[t]);
    const auto field = [&](const std::string& key, const std::string& name, auto part) {
      const auto &a = candidate[t].*part, &b = reference[t].*part, &c = finer[t].*part;
      add({key + "_l2", "relative L2 of " + name + at, index, "", relative_l2(a, b, weight), relative_l2(c, b, weight),
           ""});
      add({key + "_linf", "largest difference of " + name + at, index, "", relative_linf(a, b), relative_linf(c, b),
           ""});
    };
    field("pressure", "pore pressure", &Profile::pressure);
    field("saturation", "saturation", &Profile::saturation);
    if (range > 0)
      add({"pressure_l2_range", "rms difference of pore pressure over the initial range" + at, index, "",
           root_mean_square(candidate[t].pressure, reference[t].pressure, weight) / range,
           root_mean_square(finer[t].pressure, reference[t].pressure, weight) / range, ""});
    front(t, {&candidate[t], &reference[t], &finer[t]});
  }
}

/// The nodes themselves, for schemes whose unknowns live there. Nodes are weighted alike.
void Measuring::nodes() {
  const auto reference = pressure_at_nodes(reference_, candidate_.mesh);
  const auto finer = pressure_at_nodes(finer_, candidate_.mesh);
  const std::vector<double> alike(candidate_.mesh.node_count(), 1);
  for (std::size_t t = 0; t < std::min({candidate_.snapshots.size(), reference.size(), finer.size()}); ++t) {
    if (candidate_.snapshots[t].cells_hold_averages) continue;  // its unknowns are in the cells
    add({"pressure_l2_nodes",
         "relative L2 of pore pressure at the nodes at " +
             describe(scene_.comparison.times[t], timeline_.comparison_times[t]),
         static_cast<int>(t), "", relative_l2(candidate_.snapshots[t].node_pressure, reference[t], alike),
         relative_l2(finer[t], reference[t], alike), ""});
  }
}

void Measuring::front(std::size_t time, const std::array<const Profile*, 3>& profile) {
  if (!std::holds_alternative<Column>(scene_.geometry.shape)) return;
  const meshes::Mesh& mesh = candidate_.mesh;
  std::vector<double> elevation;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    elevation.push_back(mesh.cell_centre(c)[meshes::up_axis(mesh.dim)]);
  std::array<double, 3> at;
  for (int i = 0; i < 3; ++i) at[i] = front_elevation(profile[i]->saturation, elevation);
  const auto difference = [&](double a, double b) {
    if (std::isnan(a) && std::isnan(b)) return nothing;
    return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::abs(a - b);
  };
  add({"front_position",
       "elevation of the wetting front at " + describe(scene_.comparison.times[time], timeline_.comparison_times[time]),
       static_cast<int>(time), "", difference(at[0], at[1]), difference(at[2], at[1]),
       fmt::format("candidate {} m, reference {} m", value_text(at[0]), value_text(at[1]))});
}

void Measuring::infiltration() {
  const std::size_t times = timeline_.comparison_times.size();
  for (std::size_t t = 0; t < times; ++t) {
    const double time = timeline_.comparison_times[t];
    const auto infiltrated = [&](const meshes::FieldHistory& history) {
      return ledger_at(history.ledger, &meshes::LedgerRow::infiltrated, time) / area_of(history);
    };
    const double a = infiltrated(candidate_), b = infiltrated(reference_), c = infiltrated(finer_);
    // Where all rain runs off, what both take in is round-off of the rain, and its ratio says nothing.
    const double noise = 1e-9 * rain_asked(scene_, candidate_.mesh, time) / area_of(candidate_);
    if (!(a > noise || b > noise)) continue;
    add({"cumulative_infiltration", "cumulative infiltration at " + describe(scene_.comparison.times[t], time),
         static_cast<int>(t), "", relative_difference(a, b), relative_difference(c, b),
         fmt::format("candidate {:.6g} m, reference {:.6g} m", a, b)});
  }
}

void Measuring::events() {
  const std::array<double, 3> ponding = {ponding_time(candidate_.ledger), ponding_time(reference_.ledger),
                                         ponding_time(finer_.ledger)};
  add_event("ponding_time", "time of ponding [s]", "", ponding);
  // Where the soil takes all rain until it is full, it is full when it ponds: deficit / rain, with no solver involved.
  if (!timeline_.filling_time || timeline_.end() < *timeline_.filling_time) return;
  const double expected = *timeline_.filling_time;
  const double before = ledger_at(reference_.ledger, &meshes::LedgerRow::run_off, 0.99 * expected);
  if (before > 1e-6 * ledger_at(reference_.ledger, &meshes::LedgerRow::rain_asked, expected)) return;
  add({"filling_time", "filling time against storage deficit / rain", -1, "", relative_difference(ponding[0], expected),
       relative_difference(ponding[1], expected),
       fmt::format("candidate {} s, deficit / rain {:.6g} s, reference {} s", value_text(ponding[0]), expected,
                   value_text(ponding[1]))});
}

void Measuring::gauges() {
  const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
  for (const meshes::Gauge& gauge : candidate_.gauges) {
    const auto same = [&](const meshes::FieldHistory& history) -> const meshes::Gauge* {
      for (const meshes::Gauge& other : history.gauges)
        if (other.name == gauge.name) return &other;
      return nullptr;
    };
    const meshes::Gauge *reference = same(reference_), *finer = same(finer_);
    if (!reference || !finer) continue;
    add_event("arrival_time", "p > 0.2 kPa at probe " + gauge.name + " [s]", gauge.name,
              {crossing_time(gauge, arrival_pressure), crossing_time(*reference, arrival_pressure),
               crossing_time(*finer, arrival_pressure)});
    add_event("rise_rate", "rise of head at probe " + gauge.name + " [m/s]", gauge.name,
              {rise_rate(gauge, unit_weight), rise_rate(*reference, unit_weight), rise_rate(*finer, unit_weight)});
  }
}

void Measuring::balances() {
  add({"water_balance", "water balance of the candidate, nodal", -1, "",
       imbalance(candidate_.ledger, timeline_.stage_end), 0, ""});
  add({"reference_balance", "water balance of the reference", -1, "", imbalance(reference_.ledger, {timeline_.end()}),
       0, ""});
  const double end = candidate_.ledger.back().time;
  const double asked = rain_asked(scene_, candidate_.mesh, end);
  if (!(asked > 0)) return;
  add({"rain_asked", "rain the candidate's boundary was asked for, against the scene", -1, "",
       relative_difference(candidate_.ledger.back().rain_asked, asked), 0, ""});
  double from = 0, worst_nodal = 0, worst_points = 0;
  for (const double until : timeline_.stage_end) {
    worst_nodal = std::max(worst_nodal, undelivered(candidate_.ledger, from, until, Sum::nodal));
    const double points = undelivered(candidate_.ledger, from, until, Sum::points);
    if (!std::isnan(points)) worst_points = std::max(worst_points, points);
    from = until;
  }
  add({"rain_delivered", "rain delivered, from stored water, against asked less run-off", -1, "", worst_nodal, 0,
       fmt::format("the same from particle sums: {:.3g}", worst_points)});
}

void Measuring::overshoot() {
  if (scene_.rains.empty()) return;
  double highest = 0;
  for (const Rain& rain : scene_.rains)
    for (const meshes::Snapshot& snapshot : candidate_.snapshots)
      for (const int node : candidate_.mesh.side(rain.side).faces)
        highest = std::max(highest, snapshot.node_pressure[node]);
  add({"overshoot", "largest pressure above zero at the rained surface [Pa]", -1, "", highest, 0, ""});
}

}  // namespace

std::vector<Measurement> measure(const Scene& scene, const Timeline& timeline, const Histories& histories) {
  return Measuring(scene, timeline, histories).all();
}

}  // namespace wetfront::verification
