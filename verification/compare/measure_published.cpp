#include "verification/compare/events.h"
#include "verification/compare/measuring.h"
#include "verification/scene/known_value.h"
#include "verification/translate/initial_pressure.h"

namespace wetfront::verification {

/// What gauges say against the published simulation that the scene's [[observed]] rows name.
void Measuring::published() {
  const double unit_weight = scene_.water->density * gravity_magnitude(scene_);
  const auto against = [&](const std::string& quantity, const std::string& of, const std::string& what,
                           const std::string& probe, double here) {
    const auto known = known_value(scene_, of, Source::simulated);
    if (!known) return;
    Measurement found{quantity, what + ", against the published simulation", -1, probe, 0, {}, ""};
    found.error = std::isnan(here) ? std::numeric_limits<double>::infinity() : relative_distance(here, *known);
    const std::string said = known->low < known->high ? fmt::format("{:.4g} to {:.4g}", known->low, known->high)
                                                      : fmt::format("{:.4g}", known->low);
    found.explanation = fmt::format("here {}, published {} {}", value_text(here), said, unit_of_known(of));
    add(std::move(found));
  };
  for (const meshes::Gauge& gauge : candidate_.gauges) {
    const double arrival = crossing_time(gauge, arrival_pressure);
    against("published_arrival_time", "arrival_time:" + gauge.name, "first rise at " + gauge.name, gauge.name, arrival);
    against("published_rise_rate", "rise_rate:" + gauge.name, "rise of head at " + gauge.name, gauge.name,
            rise_rate(gauge, unit_weight));
    for (const meshes::Gauge& other : candidate_.gauges)
      if (&other != &gauge)
        against("published_interval", "interval:" + gauge.name + ":" + other.name,
                "from the rise at " + gauge.name + " to that at " + other.name, gauge.name,
                crossing_time(other, arrival_pressure) - arrival);
  }
}

}  // namespace wetfront::verification
