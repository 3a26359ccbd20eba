#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

/// Words that the checks of a problem share.
namespace wetfront::fem_reference {

/// Throws std::invalid_argument with the parts as its message.
template <class... Parts>
void require(bool good, const Parts&... parts) {
  if (good) return;
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

/// "soils[2]".
inline std::string entry(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

inline bool positive(double x) {
  return std::isfinite(x) && x > 0;
}

}  // namespace wetfront::fem_reference
