#pragma once

#include "reports/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::reports {

/// What is kept of a run of a case when the next one takes its place.
struct PastRun {
  std::string date, commit;
  bool dirty = false;
  Verdict verdict = Verdict::info;
  double cpu_seconds = 0;
  struct Value {
    std::string quantity;
    int number = 0;  ///< of the findings of this quantity, in the record's order
    double error = 0, tolerance = 0;
    Verdict verdict = Verdict::info;
  };
  std::vector<Value> values;  ///< gated findings
};

/// Adds the record as a line to `history.jsonl` in its folder; nothing when it tells no date, or is that of the last
/// line (rendered again). Throws std::runtime_error when it cannot.
void remember(const Record& record, const std::filesystem::path& folder);

/// The newest runs, oldest first; a line that was torn is left out.
std::vector<PastRun> past_runs(const std::filesystem::path& folder, std::size_t most = 20);

/// One quantity through the runs as a small drawing: a dot per run, error over tolerance, the upper line the tolerance;
/// its title tells dates and numbers. Empty when fewer than two runs have it.
std::string trend(const std::vector<PastRun>& runs, const std::string& quantity, int number, const std::string& unit);

}  // namespace wetfront::reports
