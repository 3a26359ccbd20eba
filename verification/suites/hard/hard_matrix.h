#pragma once

#include "reports/record.h"

#include <vector>

namespace wetfront::verification {

/// Folder of the matrix beside those of its rows.
inline constexpr const char* hard_matrix_folder = "matrix";

/// The matrix as a page, from the pages of its rows: a column per scheme; a cell is marked stable ("pass"), "refused" or
/// "fail" and leads to the scheme's findings on the row's page.
reports::Record hard_matrix(const std::vector<reports::Record>& rows);

}  // namespace wetfront::verification
