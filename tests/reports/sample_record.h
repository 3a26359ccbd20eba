#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::reports::testing {

/// A made-up record in the shape of a real one: 8 findings of all verdicts, 8 figures (log axes, shaded windows, gaps),
/// 4 tables, texts with umlauts, '<' and '&'. The numbers come from smooth functions and mean nothing.
Record sample_record(const std::string& case_name = "seed_column");

/// A small mesh of quadrilaterals with a nodal and a cell field, and points with a vector field.
std::vector<FieldFile> sample_fields();

}  // namespace wetfront::reports::testing
