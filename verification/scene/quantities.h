#pragma once

#include <string>
#include <vector>

namespace wetfront::verification {

/// What a gate can be put on. The comparison computes these under the same names.
struct Quantity {
  enum class Per { time, run, probe };  ///< one value per comparison time, per run, or per run and probe
  std::string name;
  std::string unit;  ///< "1" relative, "m" or "Pa"; of Tolerance::value and of the finding's error
  Per per;
  bool needs_filling_time;
  std::string meaning;
  bool own = false;  ///< of the run alone: can be gated without a reference
};

const std::vector<Quantity>& quantities();

/// nullptr when there is none of that name.
const Quantity* find_quantity(const std::string& name);

}  // namespace wetfront::verification
