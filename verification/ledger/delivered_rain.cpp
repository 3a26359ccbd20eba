#include "verification/ledger/delivered_rain.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// Rows that a polygon through the curve needs to stay within `slack` of it (Douglas & Peucker 1973).
void keep_corners(const std::vector<double>& x, const std::vector<double>& y, std::size_t from, std::size_t to,
                  double slack, std::vector<std::size_t>& kept) {
  std::size_t farthest = from;
  double largest = slack;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double line = y[from] + (y[to] - y[from]) * (x[i] - x[from]) / (x[to] - x[from]);
    if (std::abs(y[i] - line) > largest) largest = std::abs(y[i] - line), farthest = i;
  }
  if (farthest == from) return;
  keep_corners(x, y, from, farthest, slack, kept);
  kept.push_back(farthest);
  keep_corners(x, y, farthest, to, slack, kept);
}

}  // namespace

std::vector<double> delivered(const std::vector<meshes::LedgerRow>& ledger) {
  std::vector<double> sum(ledger.size(), 0);
  for (std::size_t i = 1; i < ledger.size(); ++i) {
    const auto &a = ledger[i - 1], &b = ledger[i];
    sum[i] = sum[i - 1] + (b.time > a.time ? b.stored - a.stored + b.outflow - a.outflow : 0);
  }
  return sum;
}

meshes::RainRecord delivered_rain(const std::vector<meshes::LedgerRow>& ledger, double area) {
  const std::vector<double> all = delivered(ledger);
  std::vector<double> time, depth;
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    if (!time.empty() && !(ledger[i].time > time.back())) continue;
    time.push_back(ledger[i].time);
    depth.push_back(all[i] / area);
  }
  const auto [low, high] = std::ranges::minmax(depth);
  std::vector<std::size_t> corners{0};
  keep_corners(time, depth, 0, time.size() - 1, 1e-4 * (high - low), corners);
  corners.push_back(time.size() - 1);
  meshes::RainRecord rain;
  for (std::size_t c = 1; c < corners.size(); ++c) {
    const std::size_t a = corners[c - 1], b = corners[c];
    rain.start.push_back(time[a]);
    rain.intensity.push_back(std::max(0.0, (depth[b] - depth[a]) / (time[b] - time[a])));
  }
  return rain;
}

}  // namespace wetfront::verification
