#include "mpm/plan/long_zeros.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wetfront::mpm {

namespace {

/// Before the first touch. Only a hint: whether it is taken changes nothing but the speed. Neighbours that are given
/// the same hint become one region, which large pages fill across their borders.
void ask_for_large_pages([[maybe_unused]] const std::vector<double>& reserved) {
#ifdef __linux__
  constexpr std::size_t page = 4096, least = 64 * page;
  const auto begin = reinterpret_cast<std::uintptr_t>(reserved.data()) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(reserved.data() + reserved.capacity()) + page - 1) / page * page;
  if (end - begin >= least) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace

std::vector<double> long_zeros(std::size_t count) {
  return std::move(long_zeros(std::vector<std::size_t>{count})[0]);
}

std::vector<std::vector<double>> long_zeros(const std::vector<std::size_t>& counts) {
  std::vector<std::vector<double>> all(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) {
    all[k].reserve(counts[k]);
    ask_for_large_pages(all[k]);
  }
  for (std::size_t k = 0; k < counts.size(); ++k) all[k].resize(counts[k]);
  return all;
}

}  // namespace wetfront::mpm
