#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::reports {

/// Whole, or with a word and a sign where a cell has a mark.
enum class TableForm { whole, glance };

/// A table as an element of a page: numbers to the right, shares with bars, marks in colour; a long one of the
/// flux audit is closed behind its title and number of rows.
std::string table_html(const Table& table, TableForm form);

}  // namespace wetfront::reports
