#pragma once

#include <cstddef>
#include <vector>

namespace wetfront::mpm {

/// `count` zeros. Long ones ask for large pages: a pass over a million points in columns else spends its time looking
/// up small ones.
std::vector<double> long_zeros(std::size_t count);
/// The same for several, one after the other in memory, so that large pages reach over columns shorter than one.
std::vector<std::vector<double>> long_zeros(const std::vector<std::size_t>& counts);

/// Asks for large pages for a long array that a kernel walks beside the columns, once it has been filled.
void gather_pages(const void* from, std::size_t bytes);

}  // namespace wetfront::mpm
