#pragma once

#include "reports/figures.h"
#include "reports/record.h"
#include "reports/run_history.h"

#include <string>
#include <vector>

namespace wetfront::reports {

/// report.html: one file that needs no other and no network. `drawn` belongs to `record.figures`, in their order.
/// `past`: earlier runs of the same case, shown beside each gated finding.
std::string report_page(const Record& record, const std::vector<DrawnFigure>& drawn, const std::vector<PastRun>& past);

/// The shell of any page: head with style, body, script.
std::string whole_page(const std::string& title, const std::string& body);

}  // namespace wetfront::reports
