#pragma once

#include "mpm/problem.h"

/// What a number has to be; each throws CannotPlan "origin: what is value (why). Correct it".
namespace wetfront::mpm {

[[noreturn]] void refuse(const Origin& origin, const std::string& what, double value, const std::string& why);
/// Positive and finite.
void want_positive(const Origin& origin, const std::string& what, double value);
/// Within the open interval.
void want_between(const Origin& origin, const std::string& what, double value, double low, double high);
/// At least `least`, and finite.
void want_at_least(const Origin& origin, const std::string& what, double value, double least);
/// Finite values at times that do not fall.
void check_record(const Origin& origin, const std::string& what, const TimeRecord& record);

}  // namespace wetfront::mpm
