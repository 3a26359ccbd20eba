#include "verification/study/safety.h"

#include "verification/present/safety_figures.h"
#include "verification/present/slide_figures.h"
#include "verification/present/tables.h"
#include "verification/run/progress.h"
#include "verification/run/scene_record.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

constexpr int even_parts = 10;

/// The scene's problem until it moves in true time, with states wanted at these times.
mpm::Problem<2> until_motion(const Prepared& prepared, std::vector<double> times) {
  mpm::Problem<2> problem = prepared.problem;
  const auto moves = std::ranges::find_if(
      problem.stages, [](const mpm::Stage& stage) { return stage.motion != mpm::SkeletonMotion::quasi_static; });
  problem.stages.erase(moves, problem.stages.end());
  if (problem.stages.empty())
    throw SceneError(
        {prepared.scene.path.string() +
         ":1:1: a factor of safety is asked for, but the scene begins with a stage that is not quasi-static (a "
         "body in motion has none). Put a [[stage]] with skeleton = \"quasi-static\" first."});
  for (const mpm::Soil& soil : problem.soils) mpm::weakened(soil, 1);  // complains before, not after the run
  const double end = problem.stages.back().end_time;
  if (times.empty())
    for (int k = 0; k <= even_parts; ++k) times.push_back(end * k / even_parts);
  if (!std::ranges::is_sorted(times) || times.front() < 0 || times.back() > end)
    throw SceneError(
        {fmt::format("{}:1:1: factors of safety are asked for at times that do not ascend from 0 s to {:g} s, the "
                     "end of the quasi-static stages (a body in motion has none). Correct --times.",
                     prepared.scene.path.string(), end)});
  problem.output_times = std::move(times);
  return problem;
}

class Walk {
 public:
  Walk(const mpm::Problem<2>& problem, const mpm::SafetySearch& search) : problem_(problem), search_(search) {}

  SafetyHistory all() {
    std::unique_ptr<mpm::Simulation<2>> run;
    try {
      run = std::make_unique<mpm::Simulation<2>>(problem_);
      look(*run);
      while (!run->finished()) {
        run->step();
        look(*run);
        show_progress(run->time(), run->end(), "infiltration");
      }
      found_.run = {run->take_history(), "", "", run->body()};
    } catch (const mpm::GaveUp& error) {
      found_.run = {error.partial, error.what(), "", run ? run->body() : mpm::BodyRecord{}};
    }
    return std::move(found_);
  }

 private:
  void look(const mpm::Simulation<2>& run) {
    const double time = run.time();
    const bool failed = run.body().stages.back().ended_by == "failure";
    if (!failed && !std::ranges::binary_search(problem_.output_times, time)) return;
    const mpm::State state = run.state();
    if (!failed || found_.states.empty() || found_.states.back().snapshot.time < time)
      found_.states.push_back({failed ? state.body.pictures.back().snapshot : state.history.snapshots.back(),
                               mpm::factor_of_safety(problem_, state, search_)});
  }

  const mpm::Problem<2> problem_;
  const mpm::SafetySearch search_;
  SafetyHistory found_;
};

}  // namespace

SafetyHistory safety_history(const Prepared& prepared, std::vector<double> times, const mpm::SafetySearch& search) {
  const ProgressLine line("MPM");
  return Walk(until_motion(prepared, std::move(times)), search).all();
}

reports::Record safety_page(const Prepared& prepared, const SafetyHistory& history) {
  const Scene& scene = prepared.scene;
  reports::Record record = record_of(scene, prepared.problem.mesh);
  record.case_name = "study_safety_" + record.case_name;
  record.title += ": the factor of safety over time";
  record.verdict = history.run.gave_up.empty() ? reports::Verdict::info : reports::Verdict::inconclusive;
  note_solver(record, "MPM", history.run);
  std::vector<SafetyRow> rows;
  for (const StateSafety& state : history.states) {
    rows.push_back({state.snapshot.time, state.factor, slope_factors(scene, prepared.problem.mesh, state.snapshot)});
    record.cpu_seconds += state.factor.cpu_seconds;
  }
  record.figures = safety_figures(rows);
  record.tables = {safety_table(rows), stage_table(history.run.body), cost_table("MPM", history.run.history)};
  return record;
}

}  // namespace wetfront::verification
