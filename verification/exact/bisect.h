#pragma once

namespace wetfront::verification::exact {

/// Where `above(x)` turns from false to true in [low, high], to the last bit. `above` must be monotone: closed forms
/// are inverted this way where derivative-based roots could leave the bracket.
template <class Predicate>
double bisect(const Predicate& above, double low, double high) {
  for (int i = 0; i < 2200; ++i) {  // 2100 halvings reach the smallest double from the largest
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (above(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace wetfront::verification::exact
