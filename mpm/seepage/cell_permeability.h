#pragma once

#include "mpm/grid/stencil.h"
#include "mpm/laws/tabulated.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

/// k_rel at the points of a cell and its derivatives by the cell's nodal pressures.
///
/// In smooth cells k_rel of the point's own pressure. Where k_rel differs by more than `steep_from` between the cell's
/// nodes a point takes the mean over the pressures of its own domain, the box of its share of the cell around it:
///
///   k = 1/(p_hi - p_lo) integral of k_rel from p_lo to p_hi   (Kirchhoff),
///
/// p_lo, p_hi the least and greatest pressure at the corners of the box (p_h is linear along every edge). The boxes of
/// seeded points fill a cell: along a line the sum is the exact integral of k_rel(p_h), however thin the front is,
/// where a value at a point sees nothing of a front that lies between points and shuts the water out. Between
/// `steep_from` and `steep_fully` the two are blended, weight t^2 (3 - 2 t), t in the logarithm of the ratio, so that
/// the flux keeps a continuous slope.
template <int dim>
class CellPermeability {
 public:
  static constexpr int n = cell_nodes<dim>;
  static constexpr double steep_from = 10, steep_fully = 100;
  struct Value {
    double value = 0;               ///< k_rel [-]
    std::array<double, n> slope{};  ///< d k_rel / dp_j [1/Pa]
  };

  CellPermeability(const TabulatedPermeability& law, const std::array<double, n>& pressure)
      : law_(law), pressure_(pressure) {
    const auto [low, high] = std::minmax_element(pressure.begin(), pressure.end());
    low_ = static_cast<int>(low - pressure.begin());
    high_ = static_cast<int>(high - pressure.begin());
    const ValueAndSlope most = law.at(-*high), least = law.at(-*low);
    if (!(most.value > steep_from * least.value)) return;
    // The table ends where k_rel underflows: then the cell is steep beyond all doubt.
    const double ratio = most.value / std::max(least.value, 1e-300);
    constexpr double range = 2.302585092994046;  // ln(steep_fully / steep_from)
    const double t = std::min(1.0, std::log(ratio / steep_from) / range);
    steepness_ = t * t * (3 - 2 * t);
    const double slope = t < 1 ? 6 * t * (1 - t) / range : 0;
    high_slope_ = -slope * most.slope / most.value;
    low_slope_ = slope * least.slope / std::max(least.value, 1e-300);
  }

  /// At a point of shape values N_j, pressure p; `reach`: half its box's width in local coordinates.
  Value at(const std::array<double, n>& shape, double p, double reach) const {
    const ValueAndSlope here = law_.at(-p);
    Value result{here.value, {}};
    for (int j = 0; j < n; ++j) result.slope[j] = -here.slope * shape[j];
    if (steepness_ > 0) blend(shape, reach, result);
    return result;
  }
  bool steep() const { return steepness_ > 0; }

 private:
  void blend(const std::array<double, n>& shape, double reach, Value& result) const {
    const Value mean = mean_over_box(shape, reach);
    const double difference = mean.value - result.value;
    result.value += steepness_ * difference;
    for (int j = 0; j < n; ++j) result.slope[j] += steepness_ * (mean.slope[j] - result.slope[j]);
    result.slope[high_] += difference * high_slope_;
    result.slope[low_] += difference * low_slope_;
  }

  Value mean_over_box(const std::array<double, n>& shape, double reach) const {
    Vector<dim> centre{};
    for (int a = 0; a < dim; ++a) {
      for (int i = 0; i < n; ++i) centre[a] += node_sign(i, a) * shape[i];
      centre[a] = std::clamp(centre[a], reach - 1, 1 - reach);
    }
    std::array<double, n> low_shape{}, high_shape{};
    double low = 0, high = 0;
    for (int corner = 0; corner < n; ++corner) {
      std::array<double, n> at_corner{};
      double p = 0;
      for (int i = 0; i < n; ++i) {
        at_corner[i] = 1;
        for (int a = 0; a < dim; ++a)
          at_corner[i] *= 0.5 * (1 + node_sign(i, a) * (centre[a] + node_sign(corner, a) * reach));
        p += at_corner[i] * pressure_[i];
      }
      if (corner == 0 || p < low) low = p, low_shape = at_corner;
      if (corner == 0 || p > high) high = p, high_shape = at_corner;
    }
    const ValueAndSlope wet = law_.at(-high), dry = law_.at(-low);
    const double range = high - low;
    Value mean;
    if (!(range > 1e-6 * (std::abs(high) + std::abs(low)))) {
      mean.value = 0.5 * (wet.value + dry.value);
      for (int j = 0; j < n; ++j) mean.slope[j] = -0.5 * (wet.slope * high_shape[j] + dry.slope * low_shape[j]);
      return mean;
    }
    mean.value = (law_.integral(-high) - law_.integral(-low)) / range;
    for (int j = 0; j < n; ++j)
      mean.slope[j] = ((wet.value - mean.value) * high_shape[j] + (mean.value - dry.value) * low_shape[j]) / range;
    return mean;
  }

  const TabulatedPermeability& law_;
  const std::array<double, n>& pressure_;
  int low_ = 0, high_ = 0;
  double steepness_ = 0, high_slope_ = 0, low_slope_ = 0;  ///< weight of the mean, d/dp at the extreme nodes
};

}  // namespace wetfront::mpm
