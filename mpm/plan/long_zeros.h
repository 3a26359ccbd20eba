#pragma once

#include <cstddef>
#include <vector>

namespace wetfront::mpm {

/// Zeros; long ones lie in large pages where the system has them (a kernel walks ten columns at a time, and each of them
/// needs its own page).
std::vector<double> long_zeros(std::size_t count);

}  // namespace wetfront::mpm
