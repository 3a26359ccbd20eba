#pragma once

#include "reports/record.h"
#include "reports/run_history.h"

#include <string>

namespace wetfront::reports {

/// "PASS", "FAIL", "INCONCLUSIVE", "INFO" as a coloured badge: colour, word and sign say the same.
std::string badge(Verdict verdict);

/// The findings as an HTML table, by group in order of first appearance.
std::string verdict_table(const Record& record, const std::vector<PastRun>& past);

/// "7 PASS, 1 FAIL" as HTML, verdicts that occur only.
std::string verdict_counts(const Record& record);

}  // namespace wetfront::reports
