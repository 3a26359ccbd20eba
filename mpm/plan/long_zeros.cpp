#include "mpm/plan/long_zeros.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace wetfront::mpm {

namespace {

// Only hints: whether they are taken changes nothing but the speed.

/// Arrays up to 32 MB from the heap: mapped each by itself, those shorter than a large page never get one.
void keep_together() {
#ifdef __GLIBC__
  [[maybe_unused]] static const int done = mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

/// Before the first touch.
void ask_for_large_pages([[maybe_unused]] const std::vector<double>& reserved) {
#ifdef __linux__
  constexpr std::size_t page = std::size_t{1} << 21;
  const auto begin = (reinterpret_cast<std::uintptr_t>(reserved.data()) + page - 1) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(reserved.data() + reserved.capacity()) / page * page;
  if (end > begin) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace

/// Memory that was in use before has small pages already, and arrays shorter than a large one share it with their
/// neighbours. Linux from 6.1 on can gather them at once.
void gather_pages([[maybe_unused]] const void* from, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::size_t page = std::size_t{1} << 21, least = page / 8;
  constexpr int collapse = 25;  // MADV_COLLAPSE, which older headers do not know
  if (bytes < least) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(from);
  for (auto k = begin / page; k <= (begin + bytes - 1) / page; ++k)
    madvise(reinterpret_cast<void*>(k * page), page, collapse);
#endif
}

std::vector<double> long_zeros(std::size_t count) {
  return std::move(long_zeros(std::vector<std::size_t>{count})[0]);
}

std::vector<std::vector<double>> long_zeros(const std::vector<std::size_t>& counts) {
  keep_together();
  std::vector<std::vector<double>> all(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) {
    all[k].reserve(counts[k]);
    ask_for_large_pages(all[k]);
  }
  for (std::size_t k = 0; k < counts.size(); ++k) all[k].resize(counts[k]);
  for (const auto& values : all) gather_pages(values.data(), values.size() * sizeof(double));
  return all;
}

}  // namespace wetfront::mpm
