#include "reports/tolerance_bar.h"

#include "reports/number_text.h"
#include "reports/record_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace wetfront::reports {

double tolerance_share(const Finding& finding) {
  if (finding.verdict == Verdict::info || !(finding.tolerance > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::abs(finding.error) / finding.tolerance;
}

std::string tolerance_bar(const Finding& finding) {
  const double share = tolerance_share(finding);
  if (std::isnan(share)) return "";
  // Pixels: the tolerance lies at 80, the scale ends at 120 = 1.5 tolerances.
  const auto pixel = [](double part) { return std::clamp(80 * part, 0.0, 120.0); };
  const double bound = std::abs(finding.reference_bound) / finding.tolerance;
  const double end = std::max(pixel(share), 1.0), low = pixel(share - bound), high = pixel(share + bound);
  const std::string words = number_text(100 * share, share < 10 ? 2 : 3) + "\u00a0%";
  std::ostringstream svg;
  svg << "<svg class=\"bar " << verdict_key(finding.verdict) << "\" viewBox=\"0 0 124 18\" width=\"124\" height=\"18\""
      << " role=\"img\" aria-label=\"error is " << words << " of the tolerance\">"
      << "<rect class=\"track\" x=\"0\" y=\"6\" width=\"80\" height=\"6\"/>"
      << "<rect class=\"fill\" x=\"0\" y=\"6\" width=\"" << end << "\" height=\"6\"/>";
  if (pixel(share) >= 120) svg << "<path class=\"fill\" d=\"M118 4 l6 5 l-6 5 z\"/>";
  if (bound > 0 && std::isfinite(bound))
    svg << "<path class=\"bound\" d=\"M" << low << " 9 H" << high << " M" << low << " 5.5 v7 M" << high
        << " 5.5 v7\"/>";
  svg << "<path class=\"limit\" d=\"M80 1 v16\"/></svg><span class=\"share\">" << words << "</span>";
  return svg.str();
}

}  // namespace wetfront::reports
