#pragma once

#include "reports/record.h"

namespace wetfront::verification {

/// CPU seconds at an error on a curve of error (y) over CPU seconds (x), on the straight line between neighbours in
/// log-log; NaN beyond the runs made.
double cpu_at(const reports::Series& curve, double error);

}  // namespace wetfront::verification
