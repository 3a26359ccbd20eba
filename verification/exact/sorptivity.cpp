#include "verification/exact/sorptivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// Chebyshev nodes (first kind) on [-1, 1], with Clenshaw-Curtis-like weights for the integral from -1 to each node and
/// to +1: 12 of them integrate degree 11 exactly, and graded panels keep every integrand smooth on its own panel.
struct Rule {
  static constexpr int size = 12;
  std::array<double, size> node;
  std::array<std::array<double, size>, size + 1> weight;  ///< row i: to node i; last row: to +1
};

Rule make_rule() {
  using std::numbers::pi;
  constexpr int n = Rule::size;
  Rule rule;
  for (int j = 0; j < n; ++j) rule.node[j] = -std::cos(pi * (j + 0.5) / n);
  // integral from -1 to x of T_k
  const auto primitive = [](int k, double x) {
    const auto chebyshev = [&](int m) { return std::cos(m * std::acos(std::clamp(x, -1.0, 1.0))); };
    const auto sign = [](int m) { return m % 2 == 0 ? 1.0 : -1.0; };
    if (k == 0) return x + 1;
    if (k == 1) return 0.5 * (x * x - 1);
    return 0.5 * ((chebyshev(k + 1) - sign(k + 1)) / (k + 1) - (chebyshev(k - 1) - sign(k - 1)) / (k - 1));
  };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j) {
      double w = 0;
      for (int k = 0; k < n; ++k)
        w += (k == 0 ? 1.0 : 2.0) / n * std::cos(k * std::acos(rule.node[j])) * primitive(k, i < n ? rule.node[i] : 1);
      rule.weight[i][j] = w;
    }
  return rule;
}

const Rule& rule() {
  static const Rule made = make_rule();
  return made;
}

/// Ends graded by factors of two: F behaves like Theta ln(1/Theta) at 0, and D may steepen without bound towards 1.
/// What lies below 2^-45 and above 1 - 2^-45 adds less than 1e-12 to N(0).
std::vector<double> graded_edges() {
  std::vector<double> edges;
  for (int k = 45; k >= 1; --k) edges.push_back(std::ldexp(1.0, -k));
  for (int k = 2; k <= 45; ++k) edges.push_back(1 - std::ldexp(1.0, -k));
  return edges;
}

double node_of(const std::vector<double>& edges, std::size_t panel, int i) {
  return edges[panel] + 0.5 * (edges[panel + 1] - edges[panel]) * (1 + rule().node[i]);
}

/// Integral of f (nodal values) from the first edge to each node; the last entry is the whole.
std::vector<double> running_integral(const std::vector<double>& edges, const std::vector<double>& f) {
  constexpr int n = Rule::size;
  std::vector<double> result(f.size() + 1);
  double before = 0;
  for (std::size_t p = 0; p + 1 < edges.size(); ++p) {
    const double half = 0.5 * (edges[p + 1] - edges[p]);
    for (int i = 0; i <= n; ++i) {
      double part = 0;
      for (int j = 0; j < n; ++j) part += rule().weight[i][j] * f[p * n + j];
      (i < n ? result[p * n + i] : result.back()) = before + half * part;
    }
    before = result.back();
  }
  return result;
}

}  // namespace

Sorptivity::Sorptivity(const std::function<double(double)>& diffusivity, double content_range)
    : range_(content_range), edges_(graded_edges()) {
  require_problem(content_range > 0, "sorptivity: the content range must be > 0");
  for (std::size_t p = 0; p + 1 < edges_.size(); ++p)
    for (int i = 0; i < Rule::size; ++i) {
      const double theta = node_of(edges_, p, i), d = diffusivity(theta);
      require_problem(d > 0 && std::isfinite(d), "sorptivity: D must be positive and finite inside (0, 1)");
      diffusivity_.push_back(d);
      concentration_.push_back(theta);
    }
  iterate();
  std::vector<double> weighted(diffusivity_);
  for (std::size_t k = 0; k < weighted.size(); ++k)
    weighted[k] *= 1 + node_of(edges_, k / Rule::size, static_cast<int>(k % Rule::size));
  parlange_ = range_ * std::sqrt(running_integral(edges_, weighted).back());
}

Sorptivity::Sorptivity(const VanGenuchten& soil, double initial, double face)
    : Sorptivity(
          [&] {
            soil.validate();
            require_problem(initial > 0 && initial < face && face < 1,
                            "sorptivity: 0 < initial < face < 1 is required (D is infinite at saturation)");
            return
                [&soil, initial, face](double theta) { return soil.diffusivity(initial + theta * (face - initial)); };
          }(),
          (soil.theta_s - soil.theta_r) * (face - initial)) {}

/// F' = G/N(0) and F = (1/N(0)) integral of G from 0, with G(Theta) = integral_Theta^1 D/F. Integrating upwards from 0
/// (rather than 1 - N/N(0)) keeps F's relative accuracy at the dry end, where it divides.
void Sorptivity::iterate() {
  const std::size_t size = diffusivity_.size();
  std::vector<double> integrand(size), tail(size);
  double before = 0;
  for (rounds_ = 1; rounds_ <= 500; ++rounds_) {
    for (std::size_t k = 0; k < size; ++k) integrand[k] = diffusivity_[k] / concentration_[k];
    const std::vector<double> inner = running_integral(edges_, integrand);
    for (std::size_t k = 0; k < size; ++k) tail[k] = inner.back() - inner[k];
    // below the first edge G is constant to its own rounding: it adds edge * G
    const double first = edges_.front() * inner.back();
    const std::vector<double> outer = running_integral(edges_, tail);
    const double whole = first + outer.back();
    for (std::size_t k = 0; k < size; ++k) concentration_[k] = (first + outer[k]) / whole;
    sorptivity_ = range_ * std::sqrt(2 * whole);
    slope_ = tail;
    for (double& s : slope_) s /= whole;
    if (std::abs(sorptivity_ - before) < 1e-13 * sorptivity_) return;
    before = sorptivity_;
  }
  require_point(false, "sorptivity: the fixed point did not come to rest in 500 rounds");
}

/// Barycentric interpolation on the panel that holds theta; linear from `at_zero` below the first edge.
double Sorptivity::interpolate(const std::vector<double>& values, double at_zero, double theta) const {
  require_point(theta > 0 && theta < 1, "sorptivity: Theta outside (0, 1)");
  if (theta <= edges_.front()) return at_zero + (values.front() - at_zero) * theta / edges_.front();
  const auto next = std::upper_bound(edges_.begin(), edges_.end() - 1, theta);
  const std::size_t panel = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - edges_.begin(), 1) - 1);
  double above = 0, below = 0;
  for (int i = 0; i < Rule::size; ++i) {
    const double gap = theta - node_of(edges_, panel, i), value = values[panel * Rule::size + i];
    if (gap == 0) return value;
    const double weight = (i % 2 == 0 ? 1 : -1) * std::sin(std::numbers::pi * (i + 0.5) / Rule::size) / gap;
    above += weight * value, below += weight;
  }
  return above / below;
}

double Sorptivity::position(double theta) const {
  // below the first edge F' is flat to a logarithm
  return sorptivity_ / range_ * interpolate(slope_, slope_.front(), theta);
}

double Sorptivity::flux_concentration(double theta) const {
  return interpolate(concentration_, 0, theta);
}

}  // namespace wetfront::verification::exact
