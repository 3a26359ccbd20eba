#include "verification/run/solve_richards.h"

#include "verification/run/history_file.h"
#include "verification/run/problem_hash.h"
#include "verification/run/progress.h"

#include <utility>

namespace wetfront::verification {

Solved solve_richards(const fem_reference::RichardsProblem& problem, const std::string& name,
                      const ReferenceStore& store) {
  const auto hash = store.folder.empty() ? std::nullopt : problem_hash(problem);
  const std::filesystem::path file = hash ? store.folder / (*hash + ".cbor") : std::filesystem::path();
  if (hash) {
    if (auto kept = read_history(file)) return {std::move(*kept), "", file.string()};
  }
  const ProgressLine line(name);
  try {
    Solved solved{fem_reference::solve(problem, show_progress), "", ""};
    if (hash) write_history(solved.history, file);
    return solved;
  } catch (const fem_reference::GaveUp& error) {
    return {error.partial, error.what(), ""};  // not kept: what failed may be cured by the next version
  }
}

}  // namespace wetfront::verification
