#pragma once

#include "mpm/laws/relative_permeability.h"
#include "mpm/laws/sampled_laws.h"

#include <memory>

/// Any retention curve and any permeability as tables: one type for all of them, so that a kernel is compiled once, and
/// 3 ns where a power takes 50. Copies share the table.
namespace wetfront::mpm {

class TabulatedCurve {
 public:
  // First piece 2^-14 Pa: S leaves S_max there by less than 1e-8 for every curve with p0 > 1 kPa and n >= 1.1.
  explicit TabulatedCurve(const SampledRetention& law)
      : table_(std::make_shared<const LogTable>(law.effective, -14)),
        s_min_(law.s_min),
        s_max_(law.s_max),
        scale_(law.pressure_scale) {}

  ValueAndSlope effective_at(double s) const { return table_->at(s); }
  /// S and dS/ds together.
  ValueAndSlope saturation_at(double s) const {
    const ValueAndSlope se = table_->at(s);
    return {s_min_ + (s_max_ - s_min_) * se.value, (s_max_ - s_min_) * se.slope};
  }
  double effective(double s) const { return table_->value(s); }
  double effective_slope(double s) const { return table_->at(s).slope; }
  double saturation(double s) const { return saturation_at(s).value; }
  double slope(double s) const { return saturation_at(s).slope; }
  double suction_at(double effective) const { return table_->suction_at(effective); }
  double pressure_scale() const { return scale_; }
  double s_min() const { return s_min_; }
  double s_max() const { return s_max_; }
  /// Saturated down to this suction (cut-off, entry) [Pa].
  double saturated_until() const { return table_->origin(); }

 private:
  std::shared_ptr<const LogTable> table_;
  double s_min_, s_max_, scale_;
};

class TabulatedPermeability {
 public:
  // First piece 1 Pa, a tenth of a millimetre of water: for the seed paper's sand it holds 4e-6 of k. Where the law
  // leaves saturation with an unbounded slope (Mualem with n < 2; n = 1.1: half of k within 0.01 Pa) it is 8 Pa: the
  // cubic that replaces the law there is what a Newton step can pass (mpm/README.md section 4).
  explicit TabulatedPermeability(const SampledLaw& law)
      : table_(std::make_shared<const LogTable>(law, leaves_top_steeply(law) ? 3 : 0)) {}

  ValueAndSlope at(double s) const { return table_->at(s); }
  /// Kirchhoff's integral of k_rel from s to the dry end [Pa].
  double integral(double s) const { return table_->integral(s); }
  template <RetentionCurve Curve>
  ValueAndSlope operator()(const Curve&, double s) const {
    return table_->at(s);
  }

 private:
  /// A law with a bounded slope loses a thousandth of what it loses over 1 Pa within the first millipascal.
  static bool leaves_top_steeply(const SampledLaw& law) {
    const auto loss = [&law](double x) { return law.top - law.at(law.origin + x).value; };
    return loss(1e-3) > 2e-3 * loss(1);
  }

  std::shared_ptr<const LogTable> table_;
};

static_assert(RetentionCurve<TabulatedCurve> && RelativePermeability<TabulatedPermeability, TabulatedCurve> &&
              RelativePermeability<TabulatedPermeability, VanGenuchten>);

/// The pair that two_velocity/content.h asks of a curve, whatever it calls the type.
struct TabulatedEffective {
  double value, slope;
  template <class Pair>
  operator Pair() const {
    return {value, slope};
  }
};
inline TabulatedEffective effective_at(const TabulatedCurve& curve, double s) {
  const ValueAndSlope se = curve.effective_at(s);
  return {se.value, se.slope};
}
inline double suction_at(const TabulatedCurve& curve, double effective) {
  return curve.suction_at(effective);
}

}  // namespace wetfront::mpm
