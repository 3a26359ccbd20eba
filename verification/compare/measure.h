#pragma once

#include "verification/compare/histories.h"
#include "verification/compare/reference_error.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// One quantity of the comparison, measured. All values in the quantity's unit (scene/quantities.h).
struct Measurement {
  std::string quantity;
  std::string description;  ///< with time or probe
  int time_index = -1;      ///< into the comparison times; -1: of the whole run
  std::string probe;
  double error = 0;  ///< candidate against reference; infinity where only one of them has it; NaN where neither has
  ReferenceError reference;  ///< what the reference itself does not know, by the same rule
  std::string explanation;
};

/// Measures everything that can be measured, whether or not the scene has a tolerance on it.
std::vector<Measurement> measure(const Scene& scene, const Timeline& timeline, const Histories& histories);

}  // namespace wetfront::verification
