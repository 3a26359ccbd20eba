#include "mpm/plan/long_zeros.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wetfront::mpm {

std::vector<double> long_zeros(std::size_t count) {
  std::vector<double> values;
  values.reserve(count);
#ifdef __linux__
  // Before the first touch. Only a hint: whether it is taken changes nothing but the speed.
  constexpr std::size_t page = std::size_t{1} << 21;
  const auto begin = (reinterpret_cast<std::uintptr_t>(values.data()) + page - 1) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(values.data() + count) / page * page;
  if (end > begin) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
  values.resize(count);
  return values;
}

}  // namespace wetfront::mpm
