#include "verification/study/study.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/study/workers.h"

#include <fmt/format.h>

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

/// Kept results, and empty ones of the points left out for their cost: only those that are not finished are planned.
std::vector<std::optional<PointResult>> kept_or_left_out(const std::filesystem::path& scene,
                                                         const std::vector<StudyPoint>& points,
                                                         const StudyOptions& options) {
  auto results = kept_points(scene, points, options.out);
  if (std::isinf(options.budget)) return results;
  for (std::size_t i = options.always; i < points.size(); ++i) {
    if (results[i]) continue;
    const double expected = expected_cpu(scene, points[i]);
    if (!(expected > options.budget)) continue;
    results[i].emplace();
    results[i]->name = points[i].name;
    results[i]->expected_cpu = expected;
  }
  return results;
}

}  // namespace

std::vector<std::optional<PointResult>> kept_points(const std::filesystem::path& scene,
                                                    const std::vector<StudyPoint>& points,
                                                    const std::filesystem::path& out) {
  std::vector<std::optional<PointResult>> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    kept.push_back(kept_point(point_folder(out, i, points[i]), point_hash(scene, points[i])));
  return kept;
}

std::vector<PointResult> run_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                    const StudyOptions& options) {
  reports::make_writable(options.out);
  auto results = kept_or_left_out(scene, points, options);
  std::vector<Work> work;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (results[i]) continue;
    Work one{{this_program().string()}, point_folder(options.out, i, points[i]) / "run.log"};
    one.command.insert(one.command.end(), options.command.begin(), options.command.end());
    one.command.insert(one.command.end(), {"--point", std::to_string(i)});
    work.push_back(std::move(one));
    number.push_back(i);
  }
  std::size_t done = points.size() - work.size();
  const auto left_out = static_cast<std::size_t>(
      std::ranges::count_if(results, [](const auto& result) { return result && result->left_out(); }));
  if (left_out > 0) say(fmt::format("{} of {} points are left out for their cost", left_out, points.size()));
  if (done > left_out)
    say(fmt::format("{} of {} points are finished and are taken as they are", done - left_out, points.size()));
  run_side_by_side(work, options.jobs > 0 ? options.jobs : processors(), [&](std::size_t w, int status) {
    const std::size_t i = number[w];
    const std::string hash = point_hash(scene, points[i]);
    results[i] = kept_point(point_folder(options.out, i, points[i]), hash);
    if (!results[i]) results[i] = died(points[i], hash, work[w].log, status);
    say(fmt::format("{:>3} of {}  {}: {}", ++done, points.size(), points[i].name, how_it_went(*results[i])));
  });
  std::vector<PointResult> all;
  for (auto& result : results) all.push_back(std::move(*result));
  return all;
}

std::vector<PointResult> gather_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                       const StudyOptions& options) {
  std::vector<PointResult> all;
  std::string missing;
  auto results = kept_or_left_out(scene, points, options);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (results[i])
      all.push_back(std::move(*results[i]));
    else
      missing += (missing.empty() ? "" : ", ") + std::to_string(i);
  }
  if (!missing.empty())
    throw std::runtime_error(fmt::format("{}: not all points are finished (missing: {}). Run those with --point",
                                         options.out.string(), missing));
  return all;
}

}  // namespace wetfront::verification
