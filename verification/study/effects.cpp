#include "verification/study/effects.h"

#include "verification/compare/gates.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// The narrowest gate on what the outcome is about, in its unit; without one 1 % of it.
void set_tolerance(const Scene& scene, const Outcome& outcome, Influence& influence) {
  const double gate = gate_on(scene, outcome.name.substr(0, outcome.name.find_first_of("@:")), outcome.value);
  influence.gated = gate > 0;
  // Pressures near zero: half of what counts as arrival (compare/events.h). Times near zero: a thousandth of the run.
  const double least = outcome.unit == "Pa" ? 100 : outcome.unit == "s" ? 1e-3 * timeline(scene).end() : 0;
  influence.tolerance = influence.gated ? gate : std::max(0.01 * std::abs(outcome.value), least);
}

}  // namespace

std::vector<Influence> influences(const Scene& scene, const PointResult& base, const PointResult& finer,
                                  const PointResult& changed, double cells) {
  std::vector<Influence> all;
  if (!base.ran() || !changed.ran()) return all;  // what was refused or gave up says nothing of the effect
  for (const Outcome& outcome : base.candidate) {
    Influence one;
    one.outcome = outcome.description;
    one.unit = outcome.unit;
    const double other = value_of(changed.candidate, outcome.name), mesh = value_of(finer.candidate, outcome.name);
    if (std::isnan(outcome.value) && std::isnan(other)) continue;
    set_tolerance(scene, outcome, one);
    one.value = outcome.value;
    one.change = other - outcome.value;
    one.uncertainty = std::abs(mesh - outcome.value);
    one.vanishes = std::isnan(other);
    one.appears = std::isnan(outcome.value);
    if (one.vanishes || one.appears) {
      one.need = cells == 1 ? Need::needed : Need::undecided;  // an event that happens only with it, or only without it
    } else if (std::isnan(one.uncertainty)) {
      one.need = Need::undecided;
    } else {
      const double size = std::abs(one.change);
      one.need = size - one.uncertainty > one.tolerance    ? Need::needed
                 : size + one.uncertainty <= one.tolerance ? Need::not_needed
                 // A change of nothing needs no doubt: the mesh is the same in both runs.
                 : size <= 1e-3 * one.tolerance ? Need::not_needed
                                                : Need::undecided;
    }
    all.push_back(one);
  }
  return all;
}

Need overall_need(const std::vector<Influence>& influences) {
  if (influences.empty()) return Need::unknown;
  Need worst = Need::not_needed;
  for (const Influence& one : influences) {
    if (one.need == Need::needed) return Need::needed;
    if (one.need != Need::not_needed) worst = Need::undecided;
  }
  return worst;
}

}  // namespace wetfront::verification
