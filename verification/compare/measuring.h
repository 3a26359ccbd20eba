#pragma once

#include "meshes/evaluate.h"
#include "verification/compare/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// How measure() works: values read from every solution by the same rule, compared by the same distance.
namespace wetfront::verification {

inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// |a - b| / |b|, infinity where only one exists, NaN where neither does.
inline double relative_difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return nothing;
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
  return std::abs(a - b) / std::abs(b);
}

inline double absolute_difference(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return nothing;
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : std::abs(a - b);
}

inline Distance of_numbers(double (*difference)(double, double)) {
  return [difference](const std::vector<double>& a, const std::vector<double>& b) { return difference(a[0], b[0]); };
}

inline std::string value_text(double value) {
  return std::isnan(value) ? "never" : fmt::format("{:.6g}", value);
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
    published();
    balances();
    side_fluxes();
    water_lost();
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
  void published();
  void balances();
  void side_fluxes();
  void water_lost();
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

}  // namespace wetfront::verification
