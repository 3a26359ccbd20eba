#include "verification/commands/commands.h"
#include "verification/run/run_scene.h"
#include "verification/suites/hard/hard_suite.h"
#include "verification/suites/hydraulics/hydraulics_suite.h"
#include "verification/suites/mechanics/mechanics_suite.h"
#include "verification/suites/reference_suite.h"
#include "verification/suites/run_suite.h"

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification::commands {
namespace {

struct Suite {
  std::string name;
  bool (*run)(const SuiteOptions&);
};

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all = {
      {"reference",
       [](const SuiteOptions& options) {
         return run_suite(reference_suite(), options, "The reference and what it is held against");
       }},
      {"hydraulics",
       [](const SuiteOptions& options) {
         return run_suite(hydraulics_suite(), options, "Water in the material points: schemes, sides, surfaces");
       }},
      {"hard", run_hard_suite},
      {"mechanics",
       [](const SuiteOptions& options) {
         return run_suite(mechanics_suite(), options, "Motion of the skeleton, alone and with its water");
       }},
  };
  return all;
}

}  // namespace

std::vector<std::string> suite_names() {
  std::vector<std::string> names;
  for (const Suite& suite : suites()) names.push_back(suite.name);
  return names;
}

int verify(const std::string& name, const std::filesystem::path& out, bool heavy, const std::string& only) {
  const auto suite = std::ranges::find(suites(), name, &Suite::name);
  if (suite == suites().end()) {
    std::string known;
    for (const std::string& other : suite_names()) known += (known.empty() ? "" : ", ") + other;
    throw std::invalid_argument("there is no suite '" + name + "' (there are: " + known + "). Choose one of them");
  }
  const SuiteOptions options{out.empty() ? std::filesystem::path("out/verify_" + name) : out, heavy, only};
  const bool passed = suite->run(options);
  return static_cast<int>(passed ? Exit::pass : Exit::fail);
}

}  // namespace wetfront::verification::commands
