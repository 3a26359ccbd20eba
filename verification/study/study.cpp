#include "verification/study/study.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/study/workers.h"

#include <fmt/format.h>

#include <sys/wait.h>

#include <cstdio>
#include <optional>
#include <stdexcept>

namespace wetfront::verification {
namespace {

std::string how_it_went(const PointResult& result) {
  switch (static_cast<Exit>(result.exit)) {
    case Exit::bad_input:
      return "refused: " + result.message;
    case Exit::gave_up:
      return "gave up: " + result.message;
    default:
      return fmt::format("{}, {:.2f} CPU-s", word(overall(result.findings)), result.candidate_cpu);
  }
}

PointResult died(const StudyPoint& point, const std::string& hash, const std::filesystem::path& log, int status) {
  PointResult result;
  result.name = point.name;
  result.hash = hash;
  result.exit = static_cast<int>(Exit::gave_up);
  result.message = WIFSIGNALED(status)
                       ? fmt::format("the process was ended by signal {}; see {}", WTERMSIG(status), log.string())
                       : fmt::format("the process ended early; see {}", log.string());
  return result;
}

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

std::vector<PointResult> run_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                    const StudyOptions& options) {
  reports::make_writable(options.out);
  std::vector<std::optional<PointResult>> results(points.size());
  std::vector<std::string> hashes;
  std::vector<Work> work;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i) {
    hashes.push_back(point_hash(scene, points[i]));
    const auto folder = point_folder(options.out, i, points[i]);
    results[i] = kept_point(folder, hashes[i]);
    if (!results[i] && !options.wanted.empty() && !options.wanted[i])
      results[i] = PointResult{points[i].name, hashes[i], 0, "", 0, 0, {}, {}, {}};
    if (results[i]) continue;
    Work one{{this_program().string()}, folder / "run.log"};
    one.command.insert(one.command.end(), options.command.begin(), options.command.end());
    one.command.insert(one.command.end(), {"--point", std::to_string(i)});
    work.push_back(std::move(one));
    number.push_back(i);
  }
  if (work.size() < points.size())
    say(fmt::format("{} of {} points are finished and are taken as they are", points.size() - work.size(),
                    points.size()));
  std::size_t done = points.size() - work.size();
  run_side_by_side(work, options.jobs > 0 ? options.jobs : processors(), [&](std::size_t w, int status) {
    const std::size_t i = number[w];
    const auto folder = point_folder(options.out, i, points[i]);
    results[i] = kept_point(folder, hashes[i]);
    if (!results[i]) results[i] = died(points[i], hashes[i], work[w].log, status);
    say(fmt::format("{:>3} of {}  {}: {}", ++done, points.size(), points[i].name, how_it_went(*results[i])));
  });
  std::vector<PointResult> all;
  for (auto& result : results) all.push_back(std::move(*result));
  return all;
}

std::vector<PointResult> gather_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                       const std::filesystem::path& out) {
  std::vector<PointResult> all;
  std::string missing;
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto kept = kept_point(point_folder(out, i, points[i]), point_hash(scene, points[i]));
    if (kept)
      all.push_back(std::move(*kept));
    else
      missing += (missing.empty() ? "" : ", ") + std::to_string(i);
  }
  if (!missing.empty())
    throw std::runtime_error(
        fmt::format("{}: not all points are finished (missing: {}). Run those with --point", out.string(), missing));
  return all;
}

}  // namespace wetfront::verification
