#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wetfront::mpm {

/// Hands out runs of slots, each a multiple of `unit` long and starting at one. Rooms that are given back are kept by
/// their size; nothing is allocated but by `reset`.
class SlotRooms {
 public:
  static constexpr std::size_t unit = 4;  ///< lane_count
  static constexpr std::size_t none = ~std::size_t{0};
  static constexpr std::size_t rounded(std::size_t slots) { return (slots + unit - 1) / unit * unit; }

  /// All of `slots` are free.
  void reset(std::size_t slots);
  /// First slot of a room of exactly `size` (a multiple of unit); `none` when there is none.
  std::size_t take(std::size_t size);
  void give_back(std::size_t first, std::size_t size);

 private:
  static constexpr std::size_t classes = 64;  ///< larger rooms are not reused before the next layout
  static constexpr std::uint32_t end = ~std::uint32_t{0};
  std::array<std::uint32_t, classes> head_{};
  std::vector<std::uint32_t> next_;  ///< per unit of slots: the next free room of that size
  std::size_t used_ = 0, slots_ = 0;
};

}  // namespace wetfront::mpm
