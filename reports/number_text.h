#pragma once

#include <string>

/// Numbers as a reader wants them (for pages) and as a program wants them (for files).
namespace wetfront::reports {

/// Up to `digits` significant digits (all of them before the decimal point), no trailing zeros, powers of ten written
/// out beyond 1e-3 ... 1e5: "0.083", "1772", "3.1 × 10⁻⁹", "NaN", "∞". UTF-8, true minus sign.
std::string number_text(double value, int digits = 3);

/// With its unit. Unit "1" is relative: a percentage from 1e-5 on ("0.083 %"), a bare power of ten below.
std::string quantity_text(double value, const std::string& unit, int digits = 3);

/// Shortest text that reads back to the same double; "nan", "inf", "-inf".
std::string exact_text(double value);

/// "10⁻⁵"
std::string power_of_ten(int exponent);

/// "12.3 s", "4 min 10 s", "2 h 05 min"
std::string duration_text(double seconds);

}  // namespace wetfront::reports
