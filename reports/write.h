#pragma once

#include "reports/record.h"

#include <filesystem>
#include <vector>

namespace wetfront::reports {

/// Makes the folder, clears from it what a run that was killed while it wrote left half-written, and tries whether a
/// file can be put there. Throws std::runtime_error naming the folder and the system's reason: to be called before a
/// long computation, not after it, by the one process that writes there.
void make_writable(const std::filesystem::path& folder);

/// Writes result.json (schema: result.schema.json), figures/ (CSV, gnuplot script and SVG of each) and report.html into
/// `folder`, and adds the run to its history.jsonl (run_history.h). Throws std::runtime_error naming the file that
/// cannot be written. Files appear whole or not at all.
void write_result(const Record& record, const std::filesystem::path& folder);

/// Renders report.html again from the folder's result.json (`wetfront report DIR`).
void render_again(const std::filesystem::path& folder);

/// Runs that belong together, e.g. the cases of one suite.
struct RunGroup {
  std::string title;  ///< may be empty
  std::vector<std::filesystem::path> folders;
};

/// One page over several runs: per group a verdict matrix with a link to each run's own page.
void write_index(const std::vector<RunGroup>& groups, const std::filesystem::path& page, const std::string& title);
void write_index(const std::vector<std::filesystem::path>& run_folders, const std::filesystem::path& page,
                 const std::string& title);

/// fields/<stem>_<index>.vtu and fields/<stem>.pvd for ParaView.
void write_fields(const std::vector<FieldFile>& files, const std::filesystem::path& folder);

Record read_result(const std::filesystem::path& result_json);

}  // namespace wetfront::reports
