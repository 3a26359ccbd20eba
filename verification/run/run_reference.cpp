#include "verification/run/run_reference.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/present/field_files.h"
#include "verification/present/field_pictures.h"
#include "verification/present/figures.h"
#include "verification/present/reference_error_table.h"
#include "verification/present/side_table.h"
#include "verification/present/tables.h"
#include "verification/run/provenance.h"
#include "verification/run/scene_record.h"

namespace wetfront::verification {
namespace {

/// The bounds as findings: the reference is its own candidate, and what is shown is what it does not know.
std::vector<reports::Finding> bounds(Scene scene, const Timeline& timeline,
                                     const std::vector<Measurement>& measurements, double cpu_seconds) {
  scene.comparison.tolerances.clear();  // those are the candidate's
  std::vector<reports::Finding> findings = judge(scene, timeline, measurements, cpu_seconds);
  for (reports::Finding& finding : findings)
    if (!finding.reference_convergence.empty()) finding.error = finding.reference_bound;
  return findings;
}

}  // namespace

ReferenceResult run_reference(const Scene& scene, const std::filesystem::path& folder, const ReferenceStore& store) {
  const Timeline times = timeline(scene);
  reports::make_writable(folder);
  ReferenceResult result;
  result.runs = solve_references(scene, times, store);
  const meshes::FieldHistory& history = result.runs.reference.history;

  reports::Record& record = result.record;
  record = record_of(scene, history.mesh);
  record.provenance["threads"] = threads_of_reference(history);
  record.case_name += "_reference";
  record.title += ": the reference alone";
  record.requirement = "The reference's own error: from coarser and finer meshes and a tenth of the tolerance.";
  const auto measurements = measure(scene, times, histories_of(history, result.runs));
  record.findings = bounds(scene, times, measurements, history.cpu_seconds);
  record.figures = figures_of_one(scene, history, "reference");
  record.pictures = field_pictures(history, "reference");
  record.pressure_per_head = pressure_per_head(scene);
  record.tables = {setup_table(scene, times),
                   ledger_table("reference", history, ledger_area(scene, history.mesh), times),
                   side_table("reference", history, times), reference_error_table(measurements)};
  for (const auto& [name, solved] : result.runs.all()) {
    note_solver(record, name, *solved);
    record.tables.push_back(cost_table(name, solved->history));
    if (!solved->gave_up.empty()) result.exit = Exit::gave_up;
  }
  reports::write_result(record, folder);
  reports::write_fields(field_files(history, "reference"), folder);
  return result;
}

}  // namespace wetfront::verification
