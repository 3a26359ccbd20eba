#include "verification/commands/commands.h"
#include "verification/run/run_scene.h"
#include "verification/suites/reference_suite.h"
#include "verification/suites/run_suite.h"

namespace wetfront::verification::commands {

int verify_reference(const std::filesystem::path& out, bool heavy, const std::string& only) {
  const SuiteOptions options{out.empty() ? std::filesystem::path("out/verify_reference") : out, heavy, only};
  const bool passed = run_suite(reference_suite(), options, "The reference and what it is held against");
  return static_cast<int>(passed ? Exit::pass : Exit::fail);
}

}  // namespace wetfront::verification::commands
