#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::reports {

/// A figure as CSV (RFC 4180, UTF-8, one header line, LF): two columns per series, `<series>: <label> [<unit>]` for x
/// and for y. Series may differ in length, the shorter ones end in blank cells. Numbers read back to the same double;
/// "nan", "inf", "-inf" stand for themselves. Column 2k+1 is x and 2k+2 is y of series k (k from 0), as in gnuplot's
/// `using 2*k+1:2*k+2`.
std::string figure_csv(const Figure& figure);

/// "pore pressure [kPa]"; "[-]" where the unit is "1" or empty.
std::string label_with_unit(const std::string& label, const std::string& unit);

}  // namespace wetfront::reports
