#include "verification/compare/body_outcomes.h"

#include "verification/compare/events.h"
#include "verification/compare/magnitude.h"
#include "verification/compare/window.h"
#include "verification/translate/initial_pressure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();
/// Points that have moved more than this part of the farthest belong to the slide.
constexpr double sliding = 0.2;

/// `share` of the values lie below it.
double percentile(std::vector<double> values, double share) {
  if (values.empty()) return never;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

class Body {
 public:
  Body(const Scene& scene, const meshes::FieldHistory& history, const mpm::BodyRecord& body)
      : scene_(scene), history_(history), body_(body) {}

  std::vector<Outcome> all() {
    const double failure = failure_time(body_);
    add("failure_time", "time of failure", "s", std::isfinite(failure) ? failure : never);
    riders();
    slide();
    if (scene_.water) gauges();
    return std::move(found_);
  }

 private:
  void add(const std::string& name, const std::string& description, const std::string& unit, double value) {
    found_.push_back({name, description, unit, value});
  }

  void riders() {
    double farthest = 0, fastest = 0;
    const mpm::Rider* first = nullptr;
    for (const mpm::Rider& rider : body_.riders)
      for (std::size_t k = 0; k < rider.time.size(); ++k) {
        const double moved = displacement(rider, k);
        if (moved > farthest) farthest = moved, first = &rider;
        fastest = std::max(fastest, magnitude(rider.velocity[k]));
      }
    add("largest_displacement", "largest displacement of a marker", "m", first ? farthest : never);
    add("largest_velocity", "largest velocity of a marker", "m/s", first ? fastest : never);
    add("slide_duration", "time of sliding, from 5 to 95 % of the largest displacement after failure", "s",
        first ? reaches(*first, 0.95, farthest) - reaches(*first, 0.05, farthest) : never);
    for (const mpm::Rider& rider : body_.riders)
      add("displacement:" + rider.name, "displacement of " + rider.name + " at the end", "m",
          rider.time.empty() ? never : displacement(rider, rider.time.size() - 1));
  }

  static double displacement(const mpm::Rider& rider, std::size_t k) {
    return magnitude(
        {rider.place[k][0] - rider.start[0], rider.place[k][1] - rider.start[1], rider.place[k][2] - rider.start[2]});
  }
  /// When a marker has gone this share of the way from where it was at failure: a slope creeps for long before.
  double reaches(const mpm::Rider& rider, double share, double farthest) const {
    const double failure = failure_time(body_);
    double start = 0;
    for (std::size_t k = 0; k < rider.time.size(); ++k) {
      if (std::isfinite(failure) && rider.time[k] <= failure) {
        start = displacement(rider, k);
        continue;
      }
      if (displacement(rider, k) - start >= share * (farthest - start)) return rider.time[k];
    }
    return never;
  }

  /// How deep and where the slide is at its end; and what had moved when the slope failed, which tells a skin that
  /// comes off from a layer that goes.
  void slide() {
    const mpm::Picture* last = body_.pictures.empty() ? nullptr : &body_.pictures.back();
    const auto failed = std::ranges::find(body_.pictures, "failure", &mpm::Picture::of);
    const Moved at_end = moved_in(last), at_failure = moved_in(failed == body_.pictures.end() ? nullptr : &*failed);
    add("failure_depth", "depth of what had moved at failure over the thickness (1: to the base)", "-",
        percentile(at_failure.depths, 0.95));
    add("failure_from", "foot of what had moved at failure", "m", percentile(at_failure.places, 0.05));
    add("failure_to", "head of what had moved at failure", "m", percentile(at_failure.places, 0.95));
    add("displacement_p95", "displacement that 95 % of the points stay below", "m", percentile(at_end.ways, 0.95));
    add("slide_depth", "depth of the slide over the thickness (1: to the base)", "-", percentile(at_end.depths, 0.95));
    add("slide_from", "foot of the slide", "m", percentile(at_end.places, 0.05));
    add("slide_to", "head of the slide", "m", percentile(at_end.places, 0.95));
  }

  struct Moved {
    std::vector<double> ways;            ///< of all points [m]
    std::vector<double> depths, places;  ///< of those that went along: over the thickness [-], x at the start [m]
  };
  Moved moved_in(const mpm::Picture* picture) const {
    Moved found;
    if (picture == nullptr || picture->displacement.empty() || scene_.geometry.dim() != 2) return found;
    for (const meshes::Point& d : picture->displacement) found.ways.push_back(magnitude(d));
    const double farthest = std::ranges::max(found.ways);
    for (std::size_t p = 0; p < found.ways.size(); ++p) {
      if (found.ways[p] < sliding * farthest) continue;
      const meshes::Point &x = picture->snapshot.points.position[p], &d = picture->displacement[p];
      const double from = x[0] - d[0], top = surface_at(scene_.geometry, from), base = base_at(scene_.geometry, from);
      found.depths.push_back((top - x[1] + d[1]) / (top - base));
      found.places.push_back(from);
    }
    return found;
  }

  void gauges() {
    const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
    double earliest = never;
    for (const meshes::Gauge& gauge : history_.gauges) {
      const double arrival = crossing_time(gauge, arrival_pressure);
      if (!(earliest <= arrival)) earliest = arrival;
      add("arrival_time:" + gauge.name, "pore pressure rises at " + gauge.name, "s", arrival);
      add("rise_rate:" + gauge.name, "rise of head at " + gauge.name, "m/s", rise_rate(gauge, unit_weight));
      for (const meshes::Gauge& other : history_.gauges)
        if (&other != &gauge)
          add("interval:" + gauge.name + ":" + other.name,
              "from the rise at " + gauge.name + " to that at " + other.name, "s",
              crossing_time(other, arrival_pressure) - arrival);
    }
    if (history_.gauges.empty()) return;
    const double ponds = history_.ledger.empty() ? never : ponding_time(history_.ledger);
    add("ponding_time", "the surface begins to refuse rain", "s", ponds);
    add("wetting_order", "first rise at a gauge less ponding of the surface (negative: the base first)", "s",
        earliest - ponds);
  }

  const Scene& scene_;
  const meshes::FieldHistory& history_;
  const mpm::BodyRecord& body_;
  std::vector<Outcome> found_;
};

}  // namespace

bool follows_a_body(const Scene& scene) {
  return !scene.riders.empty() || has_events(scene);
}

bool told_the_other_way(const Outcome& outcome) {
  return outcome.name.starts_with("interval:") && outcome.value < 0;
}

std::vector<Outcome> body_outcomes(const Scene& scene, const meshes::FieldHistory& history,
                                   const mpm::BodyRecord& body) {
  return Body(scene, history, body).all();
}

std::string in_words(const Outcome& outcome) {
  if (std::isnan(outcome.value)) return "";
  if (outcome.name == "slide_depth" || outcome.name == "failure_depth")
    return outcome.value >= 0.5 ? "deep" : "shallow";
  if (outcome.name == "wetting_order") return outcome.value < 0 ? "base first" : "surface first";
  return "";
}

}  // namespace wetfront::verification
