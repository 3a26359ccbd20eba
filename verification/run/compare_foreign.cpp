#include "verification/run/compare_foreign.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/ledger/difference_ledger.h"
#include "verification/present/figures.h"
#include "verification/present/reference_error_table.h"
#include "verification/present/tables.h"
#include "verification/present/worst_points.h"
#include "verification/run/provenance.h"
#include "verification/run/scene_record.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace wetfront::verification {
namespace {

/// What points at a few times can tell; balances, gauges and moments of events they cannot.
bool can_be_told(const Measurement& measurement) {
  static constexpr std::array names = {
      "pressure_l2",     "pressure_l2_range", "pressure_linf",          "saturation_l2",
      "saturation_linf", "front_position",    "cumulative_infiltration"};
  return std::ranges::find(names, measurement.quantity) != names.end();
}

reports::Finding hint(const std::string& text) {
  reports::Finding finding;
  finding.quantity = "declaration";
  finding.description = "signs and units of the declaration";
  finding.verdict = reports::Verdict::inconclusive;
  finding.error = std::nan("");
  finding.explanation = text;
  return finding;
}

/// What the numbers of the result were taken for.
reports::Table declaration_table(const ForeignResult& foreign) {
  std::string assumed;
  for (const std::string& one : foreign.assumed) assumed += (assumed.empty() ? "" : "; ") + one;
  const auto sign = [](const ForeignField& field) {
    return field.factor < 0 ? "tension-positive, turned over" : "compression-positive";
  };
  return {"What the result's numbers were taken for",
          "Set-up",
          assumed.empty() ? "All of it is declared." : "The declaration leaves out; " + assumed + ".",
          {"field", "array", "times", "sign"},
          {{"pore pressure", foreign.pressure.array, fmt::format("{:g} Pa", std::abs(foreign.pressure.factor)),
            sign(foreign.pressure)},
           {"saturation", foreign.saturation.array, fmt::format("{:g}", foreign.saturation.factor), "-"},
           {"places", "x, y, z of the points", fmt::format("{:g} m", foreign.metres), "y, or z in space, upwards"}}};
}

}  // namespace

RunResult compare_foreign(const Scene& scene, const ForeignResult& foreign, const std::filesystem::path& folder,
                          const ReferenceStore& store) {
  if (!scene.reference)
    throw SceneError({scene.path.string() +
                      ":1:1: the scene has no reference (there is nothing to compare with). Add [reference]."});
  const Timeline times = timeline(scene);
  RunResult result;
  result.candidate.history = foreign_history(foreign, scene, times);
  reports::make_writable(folder);
  result.reference = solve_references(scene, times, store);

  reports::Record& record = result.record;
  record = record_of(scene, result.candidate.history.mesh);
  record.kind = "another code's result";
  record.title = foreign.title;
  record.scene_text += "\n# ---- " + foreign.path.filename().string() + " ----\n" + foreign.text;
  record.provenance = provenance(record.scene_text, result.candidate.history.mesh, 1);
  record.provenance.erase("threads");  // the candidate's are not ours to tell
  record.provenance["candidate"] = foreign.code;
  record.tables.push_back(declaration_table(foreign));
  record.tables.push_back(setup_table(scene, times));
  for (const auto& [name, solved] : result.reference->all()) note_solver(record, name, *solved);
  note_solver(record, foreign.code, result.candidate);

  const Histories histories = histories_of(result.candidate.history, *result.reference);
  auto measurements = measure(scene, times, histories);
  std::erase_if(measurements, [](const Measurement& one) { return !can_be_told(one); });
  record.findings = judge(scene, times, measurements, 0);
  if (const std::string text = looks_wrong(histories.candidate, histories.reference); !text.empty())
    record.findings.insert(record.findings.begin(), hint(text));
  record.figures = figures(scene, times, histories, measurements);
  WorstPoints worst = worst_points(record.findings, measurements, histories);
  std::ranges::move(worst.tables, std::back_inserter(record.tables));
  record.tables.push_back(reference_error_table(measurements));
  add_ledger(record, difference_ledger({scene, times, result.candidate.history, *result.reference, {}, store}));
  record.verdict = overall(record.findings);
  result.exit = exit_for(record.verdict);
  reports::write_result(record, folder);
  reports::write_fields(worst.files, folder);
  return result;
}

}  // namespace wetfront::verification
