#include "verification/compare/measure.h"

#include "meshes/evaluate.h"
#include "verification/compare/balance.h"
#include "verification/compare/events.h"
#include "verification/compare/profile.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace wetfront::verification {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// |a - b| / |b|, infinity where only one exists, NaN where neither does.
double relative_difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return nothing;
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
  return std::abs(a - b) / std::abs(b);
}

double absolute_difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return nothing;
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::abs(a - b);
}

Distance of_numbers(double (*difference)(double, double)) {
  return [difference](const std::vector<double>& a, const std::vector<double>& b) { return difference(a[0], b[0]); };
}

std::string value_text(double value) {
  return std::isnan(value) ? "never" : fmt::format("{:.6g}", value);
}

/// Rain on a lake or river: none of the soil's business while the side is under water.
bool falls_on_water(const Scene& scene, const Rain& rain) {
  return std::ranges::any_of(scene.boundaries, [&](const Boundary& boundary) {
    return boundary.side == rain.side && boundary.water == WaterCondition::water_level;
  });
}

/// What a measurement is called.
struct Label {
  std::string quantity, description;
  int time_index = -1;
  std::string probe{};
};

/// Something read from each solution by the same rule.
struct Read {
  std::vector<double> candidate;
  ReferenceValues reference;
};

/// Gathers measurements for one scene.
class Measuring {
 public:
  Measuring(const Scene& scene, const Timeline& timeline, const Histories& histories)
      : scene_(scene),
        timeline_(timeline),
        histories_(histories),
        candidate_(histories.candidate),
        reference_(histories.reference) {}

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
  void add(const Label& label, const Read& read, const Distance& distance, std::string explanation = "") {
    add({label.quantity, label.description, label.time_index, label.probe,
         distance(read.candidate, read.reference.reference), reference_error(read.reference, distance),
         std::move(explanation)});
  }

  /// Applies `rule` (FieldHistory -> vector of doubles) to every solution.
  template <class Rule>
  Read read(const Rule& rule) const {
    Read values{rule(candidate_), read_reference(rule)};
    return values;
  }
  template <class Rule>
  ReferenceValues read_reference(const Rule& rule) const {
    ReferenceValues values{rule(reference_), {}, rule(histories_.finer), rule(histories_.tighter)};
    if (histories_.coarser) values.coarser = rule(*histories_.coarser);
    return values;
  }
  template <class Rule>
  Read read_number(const Rule& rule) const {
    return read([&](const meshes::FieldHistory& history) { return std::vector<double>{rule(history)}; });
  }

  /// An event: one number from each solution, compared with the reference's.
  void add_event(const Label& label, const Read& event) {
    add(label, event, of_numbers(relative_difference),
        fmt::format("candidate {}, reference {}", value_text(event.candidate[0]),
                    value_text(event.reference.reference[0])));
  }

  void fields();
  void front(const Label& at, const Read& saturation);
  void nodes();
  void infiltration();
  void events();
  void gauges();
  void balances();
  std::vector<meshes::Evaluator::Weights> surface_places(const std::string& side) const;
  void overshoot();

  /// Snapshots that every solution reached.
  std::size_t common_times() const {
    std::size_t times = std::min({candidate_.snapshots.size(), reference_.snapshots.size(),
                                  histories_.finer.snapshots.size(), histories_.tighter.snapshots.size()});
    if (histories_.coarser) times = std::min(times, histories_.coarser->snapshots.size());
    return times;
  }
  std::string at_time(std::size_t t) const {
    return " at " + describe(scene_.comparison.times[t], timeline_.comparison_times[t]);
  }
  double area_of(const meshes::FieldHistory& history) const { return rain_area(scene_, history.mesh); }

  const Scene& scene_;
  const Timeline& timeline_;
  const Histories& histories_;
  const meshes::FieldHistory &candidate_, &reference_;
  std::vector<Measurement> found_;
};

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
    if (range > 0)
      add({"pressure_l2_range", "rms difference of pore pressure over the initial range" + at_time(t), index}, pressure,
          of_range);
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

void Measuring::infiltration() {
  for (std::size_t t = 0; t < timeline_.comparison_times.size(); ++t) {
    const double time = timeline_.comparison_times[t];
    const Read taken = read_number([&](const meshes::FieldHistory& history) {
      return ledger_at(history.ledger, &meshes::LedgerRow::infiltrated, time) / area_of(history);
    });
    const double a = taken.candidate[0], b = taken.reference.reference[0];
    // Where all rain runs off, what both take in is round-off of the rain, and its ratio says nothing.
    const double noise = 1e-9 * rain_asked(scene_, candidate_.mesh, time) / area_of(candidate_);
    if (!(a > noise || b > noise)) continue;
    add({"cumulative_infiltration", "cumulative infiltration" + at_time(t), static_cast<int>(t)}, taken,
        of_numbers(relative_difference), fmt::format("candidate {:.6g} m, reference {:.6g} m", a, b));
  }
}

void Measuring::events() {
  const Read ponding = read_number([](const meshes::FieldHistory& history) { return ponding_time(history.ledger); });
  add_event({"ponding_time", "time of ponding [s]"}, ponding);
  // Where the soil takes all rain until it is full, it is full when it ponds: deficit / rain, with no solver involved.
  if (!timeline_.filling_time || timeline_.end() < *timeline_.filling_time) return;
  const double expected = *timeline_.filling_time;
  const double before = ledger_at(reference_.ledger, &meshes::LedgerRow::run_off, 0.99 * expected);
  if (before > 1e-6 * ledger_at(reference_.ledger, &meshes::LedgerRow::rain_asked, expected)) return;
  const double candidate = ponding.candidate[0], reference = ponding.reference.reference[0];
  Measurement filling{"filling_time", "filling time against storage deficit / rain", -1, "", 0, {}, ""};
  filling.error = relative_difference(candidate, expected);
  filling.reference.bound = relative_difference(reference, expected);  // here the truth is known
  filling.explanation = fmt::format("candidate {} s, deficit / rain {:.6g} s, reference {} s", value_text(candidate),
                                    expected, value_text(reference));
  add(std::move(filling));
}

void Measuring::gauges() {
  const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
  for (const meshes::Gauge& gauge : candidate_.gauges) {
    const auto of_gauge = [&](auto value) {
      return read_number([&](const meshes::FieldHistory& history) {
        for (const meshes::Gauge& other : history.gauges)
          if (other.name == gauge.name) return static_cast<double>(value(other));
        return nothing;
      });
    };
    add_event({"arrival_time", "p > 0.2 kPa at probe " + gauge.name + " [s]", -1, gauge.name},
              of_gauge([](const meshes::Gauge& g) { return crossing_time(g, arrival_pressure); }));
    add_event({"rise_rate", "rise of head at probe " + gauge.name + " [m/s]", -1, gauge.name},
              of_gauge([&](const meshes::Gauge& g) { return rise_rate(g, unit_weight); }));
  }
}

void Measuring::balances() {
  const auto own = [&](const std::string& quantity, const std::string& description, double error,
                       std::string explanation = "") {
    add({quantity, description, -1, "", error, {}, std::move(explanation)});
  };
  own("water_balance", "water balance of the candidate, nodal", imbalance(candidate_.ledger, timeline_.stage_end));
  own("reference_balance", "water balance of the reference", imbalance(reference_.ledger, {timeline_.end()}));
  const double end = candidate_.ledger.back().time;
  const double asked = rain_asked(scene_, candidate_.mesh, end);
  if (!(asked > 0)) return;
  if (std::ranges::none_of(scene_.rains, [&](const Rain& rain) { return falls_on_water(scene_, rain); }))
    own("rain_asked", "rain the candidate's boundary was asked for, against the scene",
        relative_difference(candidate_.ledger.back().rain_asked, asked));
  double from = 0, worst_nodal = 0, worst_points = 0;
  for (const double until : timeline_.stage_end) {
    worst_nodal = std::max(worst_nodal, undelivered(candidate_.ledger, from, until, Sum::nodal));
    const double points = undelivered(candidate_.ledger, from, until, Sum::points);
    if (!std::isnan(points)) worst_points = std::max(worst_points, points);
    from = until;
  }
  own("rain_delivered", "rain delivered, from stored water, against asked less run-off", worst_nodal,
      fmt::format("the same from particle sums: {:.3g}", worst_points));
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
    if (falls_on_water(scene_, rain)) continue;
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

}  // namespace

std::vector<Measurement> measure(const Scene& scene, const Timeline& timeline, const Histories& histories) {
  return Measuring(scene, timeline, histories).all();
}

}  // namespace wetfront::verification
