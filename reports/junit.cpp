#include "reports/junit.h"

#include "reports/escape.h"
#include "reports/number_text.h"
#include "reports/whole_file.h"

#include <cmath>
#include <sstream>

namespace wetfront::reports {

namespace {

std::string seconds(double value) {
  std::ostringstream out;
  out.setf(std::ios::fixed);
  out.precision(3);
  out << (std::isfinite(value) ? value : 0);
  return out.str();
}

std::string outcome(const Finding& finding) {
  const std::string words = "error " + quantity_text(finding.error, finding.unit) + ", tolerance " +
                            quantity_text(finding.tolerance, finding.unit) + ", reference bound " +
                            quantity_text(finding.reference_bound, finding.unit, 2);
  if (finding.verdict == Verdict::fail)
    return "<failure message=\"" + html(words) + "\">" + html(finding.explanation) + "</failure>";
  return "<skipped message=\"" + html("inconclusive: " + words + ". " + finding.explanation) + "\"/>";
}

/// "2026-11-22 14:02:00 UTC" as ISO 8601, without a zone, as JUnit has it.
std::string timestamp(const Record& record) {
  const auto date = record.provenance.find("date");
  if (date == record.provenance.end() || date->second.size() < 11) return "";
  std::string text = date->second.substr(0, date->second.find(" UTC"));
  text[10] = 'T';
  return " timestamp=\"" + html(text) + "\"";
}

struct Counted {
  std::string xml;
  int tests = 0, failures = 0, skipped = 0;

  void add(const std::string& suite, const std::string& name, double time, const std::string& inner) {
    ++tests;
    failures += inner.starts_with("<failure");
    skipped += inner.starts_with("<skipped");
    xml += "    <testcase classname=\"" + html(suite) + "\" name=\"" + html(name) + "\" time=\"" + seconds(time) +
           "\"" + (inner.empty() ? "/>" : ">" + inner + "</testcase>") + "\n";
  }
};

/// The gated findings of one run. Its CPU seconds stand at the suite: they are not to be added up over findings.
Counted suite_of(const Record& record, const std::string& name) {
  Counted all;
  bool failed = false;
  for (const Finding& finding : record.findings) {
    if (finding.verdict == Verdict::info) continue;
    failed = failed || finding.verdict == Verdict::fail;
    all.add(name, finding.description.empty() ? finding.quantity : finding.description, 0,
            finding.verdict == Verdict::pass ? "" : outcome(finding));
  }
  if (record.verdict == Verdict::fail && !failed)
    all.add(name, "verdict", record.cpu_seconds, "<failure message=\"the run as a whole failed\"/>");
  if (all.tests == 0) all.add(name, "runs", record.cpu_seconds, "<skipped message=\"nothing is gated\"/>");
  return all;
}

}  // namespace

void write_junit(const std::vector<RunGroup>& groups, const std::filesystem::path& file) {
  std::string suites;
  Counted all;
  double time = 0;
  for (const RunGroup& group : groups)
    for (const auto& folder : group.folders) {
      const Record record = read_result(folder / "result.json");
      const std::string name = (group.title.empty() ? "" : group.title + ".") + record.case_name;
      const Counted one = suite_of(record, name);
      suites += "  <testsuite name=\"" + html(name) + "\" tests=\"" + std::to_string(one.tests) + "\" failures=\"" +
                std::to_string(one.failures) + "\" errors=\"0\" skipped=\"" + std::to_string(one.skipped) +
                "\" time=\"" + seconds(record.cpu_seconds) + "\"" + timestamp(record) + ">\n" + one.xml +
                "  </testsuite>\n";
      all.tests += one.tests;
      all.failures += one.failures;
      all.skipped += one.skipped;
      time += record.cpu_seconds;
    }
  write_whole(file, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"wetfront\" tests=\"" +
                        std::to_string(all.tests) + "\" failures=\"" + std::to_string(all.failures) +
                        "\" errors=\"0\" skipped=\"" + std::to_string(all.skipped) + "\" time=\"" + seconds(time) +
                        "\">\n" + suites + "</testsuites>\n");
}

}  // namespace wetfront::reports
