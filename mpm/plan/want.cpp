#include "mpm/plan/want.h"

#include <cmath>
#include <sstream>

namespace wetfront::mpm {

void refuse(const Origin& origin, const std::string& what, double value, const std::string& why) {
  std::ostringstream text;
  if (!origin.empty()) text << origin << ": ";
  text << what << " is " << value << " (" << why << "). Correct it";
  throw CannotPlan(text.str());
}

void want_positive(const Origin& origin, const std::string& what, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(origin, what, value, "it has to be positive and finite");
}

void want_between(const Origin& origin, const std::string& what, double value, double low, double high) {
  if (!(value > low && value < high)) {
    std::ostringstream why;
    why << "it has to lie between " << low << " and " << high;
    refuse(origin, what, value, why.str());
  }
}

void want_at_least(const Origin& origin, const std::string& what, double value, double least) {
  if (value >= least && std::isfinite(value)) return;
  std::ostringstream why;
  why << "it has to be " << least << " or more, and finite";
  refuse(origin, what, value, why.str());
}

void check_record(const Origin& origin, const std::string& what, const TimeRecord& record) {
  if (record.time.size() != record.value.size())
    refuse(origin, "length of the " + what + " record", static_cast<double>(record.value.size()),
           "it has " + std::to_string(record.time.size()) + " times");
  for (std::size_t k = 0; k < record.time.size(); ++k)
    if (!std::isfinite(record.time[k]) || !std::isfinite(record.value[k]) ||
        (k > 0 && record.time[k] < record.time[k - 1]))
      refuse(origin, "entry " + std::to_string(k) + " of the " + what + " record", record.value[k],
             "times and values have to be finite, and times must not fall");
}

}  // namespace wetfront::mpm
