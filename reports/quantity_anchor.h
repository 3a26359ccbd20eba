#pragma once

#include <string>

namespace wetfront::reports {

/// The id, on a run's page, of the first finding of a quantity, gated ones first: where cells of other pages lead.
std::string quantity_anchor(const std::string& quantity);

}  // namespace wetfront::reports
