#include "verification/exact/travelling_wave.h"

#include <cmath>

#include "verification/exact/bisect.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {
constexpr double end_fraction = 1e-7;
}

TravellingWave TravellingWave::from_rate(const VanGenuchten& soil, double rate, double head_ahead) {
  soil.validate();
  require_problem(rate > 0 && rate <= soil.conductivity, "travelling wave: the rate must lie in (0, Ks]");
  return {soil, soil.head_of_conductivity(rate), head_ahead};
}

TravellingWave::TravellingWave(const VanGenuchten& soil, double head_behind, double head_ahead)
    : soil_(soil), behind_(head_behind), ahead_(head_ahead) {
  soil.validate();
  require_problem(head_ahead < head_behind && head_behind <= 0,
                  "travelling wave: head_ahead < head_behind <= 0 is required");
  content_behind_ = soil.content(behind_), content_ahead_ = soil.content(ahead_);
  conductivity_ahead_ = soil.conductivity * soil.relative_conductivity(ahead_);
  speed_ = (soil.conductivity * soil.relative_conductivity(behind_) - conductivity_ahead_) /
           (content_behind_ - content_ahead_);
  middle_ = head_at_fraction(0.5);
}

double TravellingWave::head_at_fraction(double fraction) const {
  require_point(fraction > 0 && fraction < 1, "travelling wave: the fraction must lie in (0, 1)");
  const double content = content_ahead_ + fraction * (content_behind_ - content_ahead_);
  return soil_.head_of_saturation((content - soil_.theta_r) / (soil_.theta_s - soil_.theta_r));
}

double TravellingWave::offset(double head) const {
  require_point(head > ahead_ && head < behind_, "travelling wave: the head lies outside the front");
  // d eta/d ln(-h) = h K/[(K - K_a) - v (theta - theta_a)]; K convex in theta keeps the bracket negative.
  const auto slope = [&](double log_suction) {
    const double h = -std::exp(log_suction), k = soil_.conductivity * soil_.relative_conductivity(h);
    const double bracket = (k - conductivity_ahead_) - speed_ * (soil_.content(h) - content_ahead_);
    require_point(bracket < 0, "travelling wave: K - K_a exceeds v (theta - theta_a); no monotone wave exists");
    return h * k / bracket;
  };
  return integrate(slope, std::log(-middle_), std::log(-head), 1e-11);
}

double TravellingWave::offset_at_fraction(double fraction) const {
  return offset(head_at_fraction(fraction));
}

double TravellingWave::head(double at) const {
  // eta falls as the fraction rises
  const auto behind = [&](double fraction) { return offset_at_fraction(fraction) < at; };
  require_point(offset_at_fraction(end_fraction) > at && offset_at_fraction(1 - end_fraction) < at,
                "travelling wave: the head is within 1e-7 of its limit here");
  return head_at_fraction(bisect(behind, end_fraction, 1 - end_fraction));
}

}  // namespace wetfront::verification::exact
