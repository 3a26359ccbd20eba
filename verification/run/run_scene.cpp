#include "verification/run/run_scene.h"

#include "mpm/plan.h"
#include "reports/write.h"
#include "verification/compare/balance.h"
#include "verification/compare/body_outcomes.h"
#include "verification/compare/measure_motion.h"
#include "verification/compare/missed_events.h"
#include "verification/compare/second_mesh.h"
#include "verification/compare/verdict.h"
#include "verification/compare/window.h"
#include "verification/present/body_film.h"
#include "verification/present/field_files.h"
#include "verification/present/field_pictures.h"
#include "verification/present/figures.h"
#include "verification/present/flux_tables.h"
#include "verification/present/motion_balance.h"
#include "verification/present/plan_text.h"
#include "verification/present/reference_error_table.h"
#include "verification/present/slide_figures.h"
#include "verification/present/surface_rain.h"
#include "verification/present/tables.h"
#include "verification/present/worst_points.h"
#include "verification/run/held_points.h"
#include "verification/run/ledger_of_run.h"
#include "verification/run/on_second_mesh.h"
#include "verification/run/scene_record.h"
#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

namespace wetfront::verification {
namespace {

/// What the MPM's own ledgers say, and its cost.
void add_candidate_audit(reports::Record& record, const Prepared& prepared, const RunResult& result) {
  const Solved& candidate = result.candidate;
  const meshes::FieldHistory& history = candidate.history;
  if (prepared.scene.water)
    record.tables.push_back(ledger_of_run(prepared.scene, prepared.timeline, failure_time(candidate.body), history));
  if (!prepared.scene.rains.empty()) {
    record.tables.push_back(node_rain_table(history));
    const auto* reference = result.reference ? &result.reference->reference.history : nullptr;
    if (auto figure = surface_rain_figure(history, failure_time(candidate.body), reference))
      record.figures.push_back(*figure);
  }
  if (!history.motion.empty()) record.tables.push_back(motion_table(history, prepared.timeline));
  record.tables.push_back(cost_table("MPM", history));
}

reports::Record start_record(const Prepared& prepared) {
  const Scene& scene = prepared.scene;
  reports::Record record = record_of(scene, prepared.problem.mesh);
  record.pressure_per_head = pressure_per_head(scene);
  record.plan_text = plan_text(mpm::plan(prepared.problem));
  record.tables.push_back(setup_table(scene, prepared.timeline));
  return record;
}

/// What the search for the accuracy found, and at what cost.
void add_accuracy(reports::Record& record, const AccurateCandidate& candidate) {
  record.log.push_back("MPM: " + candidate.summary);
  reports::Finding finding;
  finding.quantity = "own_error";
  finding.description = "the MPM's own error, estimated from its last refinement, against the accuracy asked for";
  finding.unit = "1";
  finding.error = candidate.estimate;
  finding.tolerance = candidate.accuracy;
  finding.reason = "asked for";
  finding.verdict = candidate.reached ? reports::Verdict::pass : reports::Verdict::fail;
  finding.cpu_s = candidate.solved.history.cpu_seconds;
  record.findings.push_back(finding);
  record.verdict = overall(record.findings);
  reports::Table table{"Runs on the way to the accuracy",
                       "Cost",
                       "Change: largest relative L2 change of pressure against the run before.",
                       {"run", "change [%]", "CPU [s]"},
                       {}};
  for (const AccuracyTry& run : candidate.tries)
    table.rows.push_back({run.resolution, std::isfinite(run.change) ? fmt::format("{:.3g}", 100 * run.change) : "-",
                          fmt::format("{:.3g}", run.cpu_seconds)});
  record.tables.push_back(std::move(table));
}

/// The body and its slide, before everything else on the page.
void add_body(reports::Record& record, const Prepared& prepared, const Solved& candidate,
              const std::optional<OnSecondMesh>& second) {
  const mpm::BodyRecord& body = candidate.body;
  if (!follows_a_body(prepared.scene)) return;
  auto pictures = slide_figures(prepared.scene, candidate.history, body);
  record.figures.insert(record.figures.begin(), std::make_move_iterator(pictures.begin()),
                        std::make_move_iterator(pictures.end()));
  const auto outcomes = body_outcomes(prepared.scene, candidate.history, body);
  std::vector<reports::Table> tables = {stage_table(body), outcome_table(outcomes, second)};
  if (!prepared.scene.observations.empty())
    tables.insert(tables.begin(), observed_table(prepared.scene, outcomes, second));
  record.tables.insert(record.tables.begin(), tables.begin(), tables.end());
}

/// What the run itself must hold, with a reference or without.
std::vector<Measurement> measure_run(const Scene& scene, const Solved& candidate,
                                     const std::optional<OnSecondMesh>& second) {
  std::vector<Measurement> measurements = measure_motion(candidate.history, failure_time(candidate.body));
  std::ranges::move(missed_events(scene, candidate.body), std::back_inserter(measurements));
  if (!second) return measurements;
  std::ranges::move(
      failure_on_two_meshes(failure_time(candidate.body), value_of(second->outcomes, "failure_time"), second->cells),
      std::back_inserter(measurements));
  return measurements;
}

/// What is painted is the ground: the empty cells above it have pressures, of nothing.
meshes::FieldHistory without_room(const Scene& scene, const meshes::FieldHistory& history) {
  return room(scene) > 0 ? on_ground(history, reference_mesh(scene, own_cells_over(scene), 0)) : history;
}

/// Figures over time say from when on the reference knows nothing of the body any more.
void shade_after(std::vector<reports::Figure>& figures, double failure, double end) {
  if (!std::isfinite(failure)) return;
  for (reports::Figure& figure : figures)
    if (figure.x_label == "time" && figure.x_unit == "s")
      figure.shaded.push_back({failure, std::max(end, failure * (1 + 1e-6)), "after failure: not comparable"});
}

/// Compares and judges; what a solver that gave up left behind is compared as far as it goes.
void compare_into(reports::Record& record, const Prepared& prepared, RunResult& result,
                  const std::optional<OnSecondMesh>& second) {
  const double failure = failure_time(result.candidate.body);
  Histories histories = histories_of(result.candidate.history, *result.reference);
  histories.candidate = without_room(prepared.scene, histories.candidate);
  const Timeline window = cut_at(prepared.timeline, failure);
  std::optional<Histories> cut;  // five histories: copied only where there is something to cut
  if (std::isfinite(failure)) cut = cut_at(histories, failure);
  auto measurements = measure(prepared.scene, window, cut ? *cut : histories);
  std::ranges::move(measure_run(prepared.scene, result.candidate, second), std::back_inserter(measurements));
  record.findings = judge(prepared.scene, window, measurements, histories.candidate.cpu_seconds);
  record.verdict = overall(record.findings);
  WorstPoints worst = worst_points(record.findings, measurements, cut ? *cut : histories);
  std::ranges::move(worst.tables, std::back_inserter(record.tables));
  result.worst_points = std::move(worst.files);
  std::erase_if(histories.candidate.snapshots, [failure](const auto& one) { return one.time > failure; });
  record.figures = figures(prepared.scene, window, histories, measurements);
  record.pictures = field_pictures(histories);
  shade_after(record.figures, failure, prepared.timeline.end());
  std::ranges::move(compared_fluxes(prepared.scene, window, failure, histories.candidate, histories.reference),
                    std::back_inserter(record.tables));
  record.tables.push_back(reference_error_table(measurements));
  for (const auto& [name, solved] : result.reference->all()) record.tables.push_back(cost_table(name, solved->history));
}

/// A scene without a reference is judged by what its run itself must hold.
void judge_alone(reports::Record& record, const Prepared& prepared, const Solved& candidate,
                 const std::optional<OnSecondMesh>& second) {
  const meshes::FieldHistory& history = candidate.history;
  const double failure = failure_time(candidate.body);
  const Timeline window = cut_at(prepared.timeline, failure);
  auto measurements = measure_run(prepared.scene, candidate, second);
  if (history.ledger.size() > 1)
    measurements.push_back({"water_balance",
                            "water balance",
                            -1,
                            "",
                            imbalance(cut_at(history.ledger, failure), window.stage_end),
                            {},
                            ""});
  record.findings = judge(prepared.scene, window, measurements, history.cpu_seconds);
  record.verdict = overall(record.findings);
  const meshes::FieldHistory ground = without_room(prepared.scene, history);
  record.figures = figures_of_one(prepared.scene, ground, "MPM");
  if (prepared.scene.water) record.pictures = field_pictures(ground, "MPM");
}

}  // namespace

Exit exit_for(reports::Verdict verdict) {
  if (verdict == reports::Verdict::fail) return Exit::fail;
  if (verdict == reports::Verdict::inconclusive) return Exit::inconclusive;
  return Exit::pass;
}

Exit worse(Exit a, Exit b) {
  static constexpr std::array ascending = {Exit::pass, Exit::inconclusive, Exit::fail, Exit::gave_up, Exit::bad_input};
  return std::ranges::find(ascending, a) >= std::ranges::find(ascending, b) ? a : b;
}

void note_solver(reports::Record& record, const std::string& who, const Solved& solved) {
  if (!solved.gave_up.empty()) record.log.push_back(who + " gave up: " + solved.gave_up);
  for (const std::string& line : solved.history.log) record.log.push_back(who + ": " + line);
  if (!solved.taken_from.empty())
    record.log.push_back(who + ": taken from " + solved.taken_from +
                         " (same problem, same code); its CPU seconds are those of the run that computed it");
  record.cpu_seconds += solved.history.cpu_seconds;
}

Prepared prepare(const Scene& scene) {
  Prepared prepared{scene, timeline(scene), {}};
  prepared.problem = to_mpm(scene, mpm_mesh(scene), prepared.timeline);
  return prepared;
}

namespace {

RunResult run_with(const Prepared& prepared, const ReferenceStore& store, const AccurateCandidate* refined,
                   const Stopping& stopping = {}) {
  RunResult result;
  result.record = start_record(prepared);
  reports::Record& record = result.record;
  if (prepared.scene.reference) {
    result.reference = solve_references(prepared.scene, prepared.timeline, store);
    for (const auto& [name, solved] : result.reference->all()) note_solver(record, name, *solved);
  }
  result.candidate = refined ? refined->solved : run_candidate(prepared.problem, stopping);
  note_solver(record, "MPM", result.candidate);
  result.stopped = result.candidate.stopped;
  const std::optional<OnSecondMesh> second = on_second_mesh(prepared, result);
  if (result.reference)
    compare_into(record, prepared, result, second);
  else
    judge_alone(record, prepared, result.candidate, second);
  tell_held_points(record, "MPM", result.candidate.history);
  record.films = body_films(prepared.scene, result.candidate.history, result.candidate.body);
  if (refined) add_accuracy(record, *refined);
  add_body(record, prepared, result.candidate, second);
  add_candidate_audit(record, prepared, result);
  result.exit = exit_for(record.verdict);
  if (!why_given_up(result).empty()) {
    result.exit = Exit::gave_up;
    // As a study says of such a point: gates held as far as it came prove nothing of the rest.
    if (record.verdict != reports::Verdict::fail) record.verdict = reports::Verdict::inconclusive;
  }
  return result;
}

}  // namespace

RunResult run_prepared(const Prepared& prepared, const ReferenceStore& store, const Stopping& stopping) {
  return run_with(prepared, store, nullptr, stopping);
}

RunResult run_prepared(const Prepared& prepared, const ReferenceStore& store, const AccurateCandidate& candidate) {
  return run_with({prepared.scene, prepared.timeline, candidate.problem}, store, &candidate);
}

std::vector<std::string> why_given_up(const RunResult& result) {
  std::vector<std::string> reasons;
  if (!result.candidate.gave_up.empty()) reasons.push_back(result.candidate.gave_up);
  if (!result.reference) return reasons;
  for (const auto& [name, solved] : result.reference->all())
    if (!solved->gave_up.empty()) reasons.push_back(name + ": " + solved->gave_up);
  return reasons;
}

CheckpointFile checkpoint_of(const Scene& scene, const std::filesystem::path& folder) {
  return {folder / "checkpoint.cbor", checkpoint_owner(scene.text)};
}

RunResult run_scene(const Scene& scene, const std::filesystem::path& folder, const RunOptions& options) {
  const double accuracy = options.accuracy > 0 ? options.accuracy : scene.mpm.accuracy;
  if (options.resume && accuracy > 0)
    throw SceneError({scene.path.string() +
                      ":1:1: --resume is given, but an accuracy is asked for (the runs that look for it keep no "
                      "checkpoint). Leave one of the two out."});
  const Prepared prepared = prepare(scene);
  if (options.ledger) check_ledger(scene, prepared.timeline);
  reports::make_writable(folder);  // before hours are spent on what could not be kept
  const Stopping stopping{checkpoint_of(scene, folder), options.checkpoint_every, options.resume};
  RunResult result = accuracy > 0
                         ? run_prepared(prepared, options.store, solve_to_accuracy(scene, prepared.timeline, accuracy))
                         : run_prepared(prepared, options.store, stopping);
  for (const std::string& note : options.notes) result.record.log.insert(result.record.log.begin(), note);
  if (options.ledger)
    add_difference_ledger(scene, prepared.timeline, options.store, result);
  else if (options.ledger_where_cheap && !(accuracy > 0))  // an accuracy's candidate is not the scene's own
    add_ledger_where_cheap(scene, prepared.timeline, options.store, result);
  reports::write_result(result.record, folder);
  auto files = field_files(result.candidate.history, "mpm", result.candidate.body);
  if (result.reference)
    for (auto& file : field_files(result.reference->reference.history, "reference")) files.push_back(std::move(file));
  std::ranges::move(result.worst_points, std::back_inserter(files));
  reports::write_fields(files, folder);
  std::ofstream(folder / "scene.toml") << scene.text;
  if (result.candidate.gave_up.empty()) forget_checkpoint(stopping.checkpoint);
  return result;
}

std::string case_name(const std::filesystem::path& scene) {
  const std::string stem = scene.stem().string();
  const std::string parent = std::filesystem::absolute(scene).parent_path().filename().string();
  return stem == "scene" && !parent.empty() ? parent : stem;
}

}  // namespace wetfront::verification
