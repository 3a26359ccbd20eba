#include "mpm/grid/slot_rooms.h"

namespace wetfront::mpm {

void SlotRooms::reset(std::size_t slots) {
  slots_ = slots;
  used_ = 0;
  head_.fill(end);
  next_.assign(slots / unit, end);
}

std::size_t SlotRooms::take(std::size_t size) {
  const std::size_t kind = size / unit;
  if (kind < classes && head_[kind] != end) {
    const std::size_t room = head_[kind];
    head_[kind] = next_[room];
    return room * unit;
  }
  if (used_ + size > slots_) return none;
  const std::size_t first = used_;
  used_ += size;
  return first;
}

void SlotRooms::give_back(std::size_t first, std::size_t size) {
  const std::size_t kind = size / unit;
  if (kind >= classes) return;
  next_[first / unit] = head_[kind];
  head_[kind] = static_cast<std::uint32_t>(first / unit);
}

}  // namespace wetfront::mpm
