#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/suites/reference_suite.h"
#include "verification/suites/work_precision.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {
int verify_reference(const std::filesystem::path& out) {
  const auto root = out.empty() ? std::filesystem::path("out/verify_reference") : out;
  int code = 0;
  std::vector<std::filesystem::path> folders;
  const auto keep = [&](const reports::Record& record) {
    const auto folder = root / record.case_name;
    std::filesystem::create_directories(folder);
    reports::write_result(record, folder);
    folders.push_back(folder);
    fmt::print("{:<12} {:<34} {:7.2f} CPU-s\n", word(record.verdict), record.case_name, record.cpu_seconds);
    for (const auto& finding : record.findings)
      if (finding.verdict == reports::Verdict::fail)
        fmt::print("             {}: {:.3g}, tolerance {:.3g}\n", finding.description, finding.error,
                   finding.tolerance);
    if (record.verdict == reports::Verdict::fail) code = static_cast<int>(Exit::fail);
  };
  const auto suite = reference_suite();
  for (const ClosedFormCase& test : suite) keep(run_closed_form(test));
  keep(work_precision(suite.front(), 100));
  reports::write_index(folders, root / "index.html", "The reference against closed forms");
  fmt::print("index of all cases -> {}\n", (root / "index.html").string());
  return code;
}

}  // namespace wetfront::verification::commands
