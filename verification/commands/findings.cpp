// What the commands say of findings.
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification::commands {

std::string amount(double value, const std::string& unit) {
  if (std::isnan(value)) return "nothing to measure";
  if (unit == "1") return fmt::format("{:.3g} %", 100 * value);
  return fmt::format("{:.3g} {}", value, unit);
}

void print_findings(const reports::Record& record) {
  for (const auto& finding : record.findings) {
    if (finding.verdict == reports::Verdict::info) continue;
    fmt::print("  {:<12}  {}: {}, tolerance {}, reference {}\n", word(finding.verdict), finding.description,
               amount(finding.error, finding.unit), amount(finding.tolerance, finding.unit),
               amount(finding.reference_bound, finding.unit));
    if (finding.verdict != reports::Verdict::pass && !finding.explanation.empty())
      fmt::print("                {}\n", finding.explanation);
  }
}

}  // namespace wetfront::verification::commands
