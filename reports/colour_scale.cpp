#include "reports/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>

namespace wetfront::reports {

namespace {

constexpr std::array<std::uint32_t, 9> viridis = {0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                                  0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
constexpr std::array<std::uint32_t, 7> blue_to_red = {0x2166ac, 0x67a9cf, 0xd1e5f0, 0xf7f7f7,
                                                      0xfddbc7, 0xef8a62, 0xb2182b};

std::string between(std::span<const std::uint32_t> colours, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t low = std::min(colours.size() - 2, static_cast<std::size_t>(place));
  std::uint32_t mixed = 0;
  for (const int shift : {16, 8, 0}) {
    const double a = colours[low] >> shift & 255, b = colours[low + 1] >> shift & 255;
    mixed |= static_cast<std::uint32_t>(std::lround(a + (b - a) * (place - static_cast<double>(low)))) << shift;
  }
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%06x", mixed);
  return text.data();
}

}  // namespace

std::string sequential_colour(double share) {
  return between(viridis, share);
}

std::string diverging_colour(double share) {
  return between(blue_to_red, share);
}

}  // namespace wetfront::reports
