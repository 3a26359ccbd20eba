#include "verification/suites/hard/hard_suite.h"

#include "reports/write.h"
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_matrix.h"

#include <filesystem>

namespace wetfront::verification {

std::vector<Case> hard_suite() {
  std::vector<Case> all;
  for (const auto family : {dry_rows, layer_rows, water_rows, rain_rows, surface_rows, carried_rows, invalid_rows})
    for (const HardCase& row : family()) all.push_back(as_case(row));
  return all;
}

bool run_hard_suite(const SuiteOptions& options) {
  const std::vector<Case> suite = hard_suite();
  const std::string title = "Hard cases";
  const bool passed = run_suite(suite, options, title);
  std::vector<std::filesystem::path> folders;
  std::vector<reports::Record> rows;
  for (const Case& test : suite) {
    if ((test.effort == Effort::heavy && !options.heavy) || test.name.find(options.only) == std::string::npos) continue;
    folders.push_back(options.out / test.name);
    rows.push_back(reports::read_result(folders.back() / "result.json"));
  }
  const std::filesystem::path matrix = options.out / hard_matrix_folder;
  reports::write_result(hard_matrix(rows), matrix);
  reports::write_index(std::vector<reports::RunGroup>{{"Stability", {matrix}}, {"Verdict by scheme", folders}},
                       options.out / "index.html", title);
  return passed;
}

}  // namespace wetfront::verification
