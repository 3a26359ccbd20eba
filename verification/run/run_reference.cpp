#include "verification/run/run_reference.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/present/field_files.h"
#include "verification/present/figures.h"
#include "verification/present/tables.h"
#include "verification/run/provenance.h"

namespace wetfront::verification {

RunResult run_reference(const Scene& scene, const std::filesystem::path& folder) {
  const Prepared prepared = prepare_reference(scene);
  reports::make_writable(folder);
  RunResult result;
  result.reference = solve_reference(prepared, false);
  result.finer = solve_reference(prepared, true);
  const meshes::FieldHistory &coarse = result.reference.history, &fine = result.finer.history;

  reports::Record& record = result.record;
  record.case_name = case_name(scene.path) + "_reference";
  record.title = scene.title + ": the reference alone";
  record.requirement =
      "The reference's own error: its difference from the same on twice the cells with a tenth of the tolerance.";
  record.scene_path = scene.path.string();
  record.scene_text = scene.text;
  record.provenance = provenance(scene.text, coarse.mesh);
  record.cpu_seconds = coarse.cpu_seconds + fine.cpu_seconds;
  Scene ungated = scene;  // the scene's tolerances are the candidate's; here the errors are only shown
  ungated.comparison.tolerances.clear();
  record.findings =
      judge(ungated, prepared.timeline, measure(scene, prepared.timeline, {coarse, fine, fine}), coarse.cpu_seconds);
  record.figures = figures_of_one(scene, coarse, "reference");
  const double area = ledger_area(scene, coarse.mesh);
  record.tables = {setup_table(scene, prepared.timeline), ledger_table("reference", coarse, area, prepared.timeline),
                   cost_table("reference", coarse), cost_table("finer reference", fine)};
  for (const Solved* solved : {&result.reference, &result.finer}) {
    for (const std::string& line : solved->history.log) record.log.push_back(line);
    if (!solved->gave_up.empty()) {
      record.log.push_back("gave up: " + solved->gave_up);
      result.exit = Exit::gave_up;
    }
  }
  reports::write_result(record, folder);
  reports::write_fields(field_files(coarse, "reference"), folder);
  return result;
}

}  // namespace wetfront::verification
