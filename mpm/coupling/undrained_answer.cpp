#include "mpm/coupling/undrained_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {
namespace {

/// Of Newton's method at a node of several soils: halving alone tells a pressure to round-off in 60.
constexpr int most_iterations = 60;

}  // namespace

void UndrainedAnswer::begin(const Column& pore_volume) {
  const std::size_t nodes = pore_volume.size();
  pores_.resize(contents_.size());
  grown_.assign(contents_.size(), std::vector<double>(nodes));
  for (std::size_t r = 0; r < pores_.size(); ++r) {
    const double* of_soil = pore_volume[static_cast<int>(r)];
    pores_[r].assign(of_soil, of_soil + nodes);
  }
}

double UndrainedAnswer::room(std::size_t node) const {
  double room = 0;
  for (const std::vector<double>& of_soil : pores_) room += of_soil[node];
  return room;
}

/// p_i <- content^-1(P_i' content(p_i)/P_i): the water of a node stays while its pores change from P_i' to P_i.
double UndrainedAnswer::answered(std::size_t node, double p) const {
  double now = 0, room = 0, grown = 0, most = 0;
  int soils = 0;
  const SoilContent* content = nullptr;
  for (std::size_t r = 0; r < contents_.size(); ++r) {
    const double pores = pores_[r][node];
    if (pores == 0 && grown_[r][node] == 0) continue;
    ++soils;
    if (content == nullptr || pores > most) content = &contents_[r], most = pores;
    now += pores * contents_[r].at(p).value;
    room += pores;
    grown += grown_[r][node];
  }
  if (!(room > 0) || grown == 0) return p;
  // As a difference, so that what the table's inverse is off does not add up.
  const double held = now / room;
  const double by_one = p + content->pressure_at(held * room / (room + grown)) - content->pressure_at(held);
  return soils == 1 ? by_one : answered_by_several(node, p, by_one);
}

/// The same where soils meet: sum_r P_r content_r(p_i) = sum_r P_r' content_r(p_i'), by Newton's method between bounds.
double UndrainedAnswer::answered_by_several(std::size_t node, double before, double guess) const {
  double held = 0, low = before, high = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < contents_.size(); ++r) held += pores_[r][node] * contents_[r].at(low).value;
  for (const SoilContent& content : contents_) low = std::min(low, content.pressure_at(0));  // the driest it can tell
  double p = std::max(guess, low);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    double excess = -held, slope = 0, room = 0;
    for (std::size_t r = 0; r < contents_.size(); ++r) {
      const double pores = pores_[r][node] + grown_[r][node];
      const ValueAndSlope now = contents_[r].at(p);
      excess += pores * now.value;
      slope += pores * now.slope;
      room += pores;
    }
    if (std::abs(excess) <= std::numeric_limits<double>::epsilon() * room) break;
    (excess > 0 ? high : low) = p;
    double next = p - excess / slope;
    if (!(next >= low && next <= high)) next = std::isinf(high) ? p + std::abs(p) + 1 : 0.5 * (low + high);
    const double change = next - p;
    p = next;
    if (std::abs(change) <= 1e-12 * std::abs(p)) break;  // round-off
  }
  return p;
}

void UndrainedAnswer::take(double* pressure) {
  const std::size_t nodes = pores_.empty() ? 0 : pores_.front().size();
  for (std::size_t i = 0; i < nodes; ++i) pressure[i] = answered(i, pressure[i]);
  for (std::size_t i = 0; i < nodes; ++i)
    if (room(i) > 0)
      for (std::size_t r = 0; r < pores_.size(); ++r) pores_[r][i] += grown_[r][i];
  for (std::vector<double>& of_soil : grown_) std::ranges::fill(of_soil, 0.0);
}

}  // namespace wetfront::mpm
