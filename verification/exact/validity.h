#pragma once

#include <stdexcept>
#include <string>

namespace wetfront::verification::exact {

/// A problem that has no such solution (a negative thickness, rain above Ks in a soil whose law ends at K = Ks).
inline void require_problem(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

/// A point or time outside the solution's range, or where it cannot be evaluated to the accuracy stated.
inline void require_point(bool holds, const std::string& message) {
  if (!holds) throw std::domain_error(message);
}

}  // namespace wetfront::verification::exact
