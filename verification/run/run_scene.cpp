#include "verification/run/run_scene.h"

#include "mpm/plan.h"
#include "mpm/simulation.h"
#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/present/field_files.h"
#include "verification/present/figures.h"
#include "verification/present/plan_text.h"
#include "verification/present/reference_error_table.h"
#include "verification/present/tables.h"
#include "verification/run/progress.h"
#include "verification/run/provenance.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace wetfront::verification {
namespace {

Exit exit_for(reports::Verdict verdict) {
  if (verdict == reports::Verdict::fail) return Exit::fail;
  if (verdict == reports::Verdict::inconclusive) return Exit::inconclusive;
  return Exit::pass;
}

void add_candidate_tables(reports::Record& record, const Prepared& prepared, const meshes::FieldHistory& history) {
  if (prepared.scene.water)
    record.tables.push_back(ledger_table("MPM", history, ledger_area(prepared.scene, history.mesh), prepared.timeline));
  if (!prepared.scene.rains.empty()) record.tables.push_back(node_rain_table(history));
  record.tables.push_back(cost_table("MPM", history));
}

reports::Record start_record(const Prepared& prepared) {
  const Scene& scene = prepared.scene;
  reports::Record record;
  record.case_name = case_name(scene.path);
  record.title = scene.title;
  record.requirement = scene.requirement;
  record.scene_path = scene.path.string();
  record.scene_text = scene.text;
  record.plan_text = plan_text(mpm::plan(prepared.problem));
  record.provenance = provenance(scene.text, prepared.problem.mesh);
  record.tables.push_back(setup_table(scene, prepared.timeline));
  return record;
}

/// Compares and judges; what a solver that gave up left behind is compared as far as it goes.
void compare_into(reports::Record& record, const Prepared& prepared, RunResult& result) {
  const Histories histories = histories_of(result.candidate.history, *result.reference);
  const auto measurements = measure(prepared.scene, prepared.timeline, histories);
  record.findings = judge(prepared.scene, prepared.timeline, measurements, histories.candidate.cpu_seconds);
  record.verdict = overall(record.findings);
  record.figures = figures(prepared.scene, prepared.timeline, histories, measurements);
  record.tables.push_back(ledger_table("reference", histories.reference,
                                       ledger_area(prepared.scene, histories.reference.mesh), prepared.timeline));
  record.tables.push_back(reference_error_table(measurements));
  for (const auto& [name, solved] : result.reference->all()) record.tables.push_back(cost_table(name, solved->history));
}

}  // namespace

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

Solved solve_candidate(const mpm::Problem<2>& problem) {
  const ProgressLine line("MPM");
  try {
    return {mpm::run(problem, show_progress), "", ""};
  } catch (const mpm::GaveUp& error) {
    return {error.partial, error.what(), ""};
  }
}

RunResult run_prepared(const Prepared& prepared, const ReferenceStore& store) {
  RunResult result;
  result.record = start_record(prepared);
  reports::Record& record = result.record;
  if (prepared.scene.reference) {
    result.reference = solve_references(prepared.scene, prepared.timeline, store);
    for (const auto& [name, solved] : result.reference->all()) note_solver(record, name, *solved);
  }
  result.candidate = solve_candidate(prepared.problem);
  note_solver(record, "MPM", result.candidate);
  if (result.reference)
    compare_into(record, prepared, result);
  else
    record.figures = figures_of_one(prepared.scene, result.candidate.history, "MPM");
  add_candidate_tables(record, prepared, result.candidate.history);
  result.exit = exit_for(record.verdict);
  if (!why_given_up(result).empty()) result.exit = Exit::gave_up;
  return result;
}

std::vector<std::string> why_given_up(const RunResult& result) {
  std::vector<std::string> reasons;
  if (!result.candidate.gave_up.empty()) reasons.push_back(result.candidate.gave_up);
  if (!result.reference) return reasons;
  for (const auto& [name, solved] : result.reference->all())
    if (!solved->gave_up.empty()) reasons.push_back(name + ": " + solved->gave_up);
  return reasons;
}

RunResult run_scene(const Scene& scene, const std::filesystem::path& folder, const ReferenceStore& store) {
  const Prepared prepared = prepare(scene);
  reports::make_writable(folder);  // before hours are spent on what could not be kept
  RunResult result = run_prepared(prepared, store);
  reports::write_result(result.record, folder);
  auto files = field_files(result.candidate.history, "mpm");
  if (result.reference)
    for (auto& file : field_files(result.reference->reference.history, "reference")) files.push_back(std::move(file));
  reports::write_fields(files, folder);
  std::ofstream(folder / "scene.toml") << scene.text;
  return result;
}

std::string case_name(const std::filesystem::path& scene) {
  const std::string stem = scene.stem().string();
  const std::string parent = std::filesystem::absolute(scene).parent_path().filename().string();
  return stem == "scene" && !parent.empty() ? parent : stem;
}

}  // namespace wetfront::verification
