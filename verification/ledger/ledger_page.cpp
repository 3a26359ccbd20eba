// How a ledger of differences is shown.
#include "verification/ledger/difference_ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr const char* section = "Difference ledger";

std::string millimetres(double metres) {
  return fmt::format("{:.4g}", 1e3 * metres);
}

reports::Finding finding_of(const QuantityLedger& entry, double time) {
  reports::Finding finding;
  finding.quantity = "ledger_" + entry.quantity;
  finding.description =
      fmt::format("what no cause explains of the difference in {} at {:.6g} s", entry.description, time);
  finding.group = section;
  finding.unit = "m";
  finding.error = std::abs(entry.remainder);
  finding.reference_bound = std::min(entry.uncertainty, small_remainder * entry.size());
  finding.tolerance = small_remainder * entry.size();
  finding.reason = "a quarter of all causes together: with more than that unexplained the named causes prove nothing";
  finding.verdict = entry.verdict;
  finding.explanation = entry.explanation;
  return finding;
}

reports::Table table_of(const QuantityLedger& entry) {
  reports::Table table;
  table.title = fmt::format("Difference in {}: {} mm", entry.description, millimetres(entry.difference()));
  table.section = section;
  table.caption =
      fmt::format("Candidate {:.6g} m, reference {:.6g} m (its own doubt {} mm).{}", entry.candidate, entry.reference,
                  millimetres(entry.reference_bound), entry.cancels ? " Causes of opposite sign hide each other." : "");
  table.header = {"cause", "share [mm]", "doubt [mm]", "of all causes [%]", "how it was told"};
  const double size = entry.size();
  const auto percent = [&](double value) {
    return size > 0 ? fmt::format("{:.1f}", 100 * std::abs(value) / size) : "0";
  };
  for (const Share& share : entry.shares) {
    const std::string note = share.note + (share.converged ? "" : "; UNCONVERGED");
    if (share.probed)
      table.rows.push_back(
          {share.cause, millimetres(share.value), millimetres(share.uncertainty), percent(share.value), note});
    else
      table.rows.push_back({share.cause, "not measured", "", "", note});
  }
  // The reference's own side: known beforehand, so in the doubt and not among the causes.
  const auto of_the_reference = [&](const Share& side, const std::string& how) {
    if (side.cause.empty()) return;
    table.rows.push_back(
        {side.cause, "", millimetres(side.uncertainty), "",
         fmt::format("{} changes it by {} mm; in the remainder's doubt", how, millimetres(side.value))});
  };
  of_the_reference(entry.reference_mesh, "the reference on cells half as large");
  of_the_reference(entry.reference_steps, "the reference with a tenth of its tolerance");
  table.rows.push_back({"remainder", millimetres(entry.remainder), millimetres(entry.uncertainty),
                        percent(entry.remainder), "what is left; also what causes do to each other"});
  return table;
}

reports::Table summary_of(const DifferenceLedger& ledger) {
  reports::Table table{"Where the differences come from",
                       section,
                       ledger.causes.empty() ? "There is no difference that matters."
                                             : fmt::format("Mainly: {}.", ledger.causes.front().first),
                       {"cause", "mean share of what there is to explain [%]"},
                       {}};
  for (const auto& [cause, share] : ledger.causes) table.rows.push_back({cause, fmt::format("{:.1f}", 100 * share)});
  return table;
}

}  // namespace

void add_ledger(reports::Record& record, const DifferenceLedger& ledger) {
  for (const QuantityLedger& entry : ledger.quantities) record.findings.push_back(finding_of(entry, ledger.time));
  record.tables.push_back(summary_of(ledger));
  for (const QuantityLedger& entry : ledger.quantities) record.tables.push_back(table_of(entry));
  for (const std::string& line : ledger.log) record.log.push_back("ledger: " + line);
  record.cpu_seconds += ledger.cpu_seconds;
}

}  // namespace wetfront::verification
