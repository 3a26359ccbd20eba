#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/suites/reference_suite.h"

#include <fmt/format.h>

#include <cstdlib>

namespace wetfront::verification::commands {
int verify_reference(const std::filesystem::path& out) {
  const auto root = out.empty() ? std::filesystem::path("out/verify_reference") : out;
  int code = 0;
  std::vector<std::filesystem::path> folders;
  const char* only = std::getenv("ONLY");
  for (const Case& test : reference_suite()) {
    if (only != nullptr && test.name.find(only) == std::string::npos) continue;
    const reports::Record record = run_case(test);
    const auto folder = root / record.case_name;
    std::filesystem::create_directories(folder);
    reports::write_result(record, folder);
    folders.push_back(folder);
    fmt::print("{:<12} {:<34} {:7.2f} CPU-s\n", word(record.verdict), record.case_name, record.cpu_seconds);
    for (const auto& finding : record.findings)
      if (finding.verdict == reports::Verdict::fail || std::getenv("VERBOSE"))
        fmt::print("             {} {}: {:.3g}, tolerance {:.3g} {}\n", word(finding.verdict), finding.description,
                   finding.error, finding.tolerance, finding.explanation);
    std::fflush(stdout);
    if (record.verdict == reports::Verdict::fail) code = static_cast<int>(Exit::fail);
  }
  reports::write_index(folders, root / "index.html", "The reference against closed forms");
  fmt::print("index of all cases -> {}\n", (root / "index.html").string());
  return code;
}

}  // namespace wetfront::verification::commands
