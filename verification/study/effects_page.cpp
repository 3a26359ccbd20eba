// The ledger of effects, as a page and as sentences.
#include "reports/write.h"
#include "verification/scene/read.h"
#include "verification/study/effects.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr const char* table_title = "Effects";

const char* word(Need need) {
  switch (need) {
    case Need::needed:
      return "needed";
    case Need::not_needed:
      return "not needed";
    case Need::undecided:
      return "undecided";
    case Need::unknown:
      break;
  }
  return "not known";
}

/// The influence that is largest in terms of its tolerance.
const Influence* largest(const std::vector<Influence>& all) {
  const auto size = [](const Influence& one) {
    return std::isnan(one.change) ? 1e300 : std::abs(one.change) / std::max(one.tolerance, 1e-300);
  };
  const auto found = std::ranges::max_element(all, {}, size);
  return found == all.end() ? nullptr : &*found;
}

std::string sentence(const EffectChange& change, const PointResult& result, const std::vector<Influence>& all) {
  if (result.left_out()) return fmt::format("Not run: its plan expects {:.3g} CPU-s.", result.expected_cpu);
  if (all.empty()) return "Could not be run: " + result.message;
  const Influence& most = *largest(all);
  const std::string effect =
      change.effect + (change.called_for ? ", which the scene calls for, " : ", which the scene does not call for, ");
  const std::string is = std::string("is ") + word(overall_need(all)) + " at this tolerance";
  if (std::isnan(most.change)) return effect + is + ": " + most.outcome + " happens only with it or only without it.";
  return fmt::format("{}{}: at most {:.3g} of the tolerance (or of 1 %), in {}.", effect, is,
                     std::abs(most.change) / std::max(most.tolerance, 1e-300), most.outcome);
}

std::string share(double with, double without) {
  return with > 0 ? fmt::format("{:.1f}", 100 * (with - without) / with) : "-";
}

}  // namespace

reports::Record effects_page(const std::filesystem::path& path, const std::vector<EffectChange>& changes,
                             const std::vector<PointResult>& results, const std::filesystem::path& out) {
  reports::Record record = start_study("which effects matter", path, results);
  record.verdict = reports::Verdict::info;
  const Scene scene = read_scene(path);
  reports::Table summary{table_title,
                         "Verdicts",
                         "Share of time and memory: what the run without the effect saves of the run with it.",
                         {"effect", "in the scene", "verdict", "time [%]", "point memory [%]", "what the scene needs"},
                         {}};
  reports::Table detail{"Influence on each outcome",
                        "Influence",
                        "Change: with the effect left out or added. Doubt: the change on cells half as large.",
                        {"effect", "outcome", "change", "doubt", "tolerance", "verdict"},
                        {}};
  for (std::size_t i = 2; i < changes.size(); ++i) {
    const auto all =
        results[i].left_out() ? std::vector<Influence>{} : influences(scene, results[0], results[1], results[i]);
    const bool called = changes[i].called_for, ran = !all.empty();
    const auto part = [&](double scene_has, double changed) {
      return !ran ? std::string("-") : called ? share(scene_has, changed) : share(changed, scene_has);
    };
    summary.rows.push_back(
        {changes[i].effect, called ? "called for" : "not called for", word(overall_need(all)),
         part(results[0].candidate_cpu, results[i].candidate_cpu),
         part(static_cast<double>(results[0].point_bytes), static_cast<double>(results[i].point_bytes)),
         sentence(changes[i], results[i], all)});
    summary.links.push_back(results[i].left_out() ? "" : link_to(out, i, changes[i].point));
    for (const Influence& one : all)
      detail.rows.push_back({changes[i].effect, one.outcome, fmt::format("{:.4g}", one.change),
                             fmt::format("{:.2g}", one.uncertainty), fmt::format("{:.3g}", one.tolerance),
                             word(one.need)});
  }
  record.tables.push_back(std::move(summary));
  record.tables.push_back(std::move(detail));
  return record;
}

std::vector<std::string> stored_effects(const Scene& scene, const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / "result.json")) return {};
  const reports::Record record = reports::read_result(folder / "result.json");
  if (record.scene_text != scene.text) return {};  // of another version of the scene
  std::vector<std::string> sentences;
  for (const auto& table : record.tables)
    if (table.title == table_title)
      for (const auto& row : table.rows)
        if (!row.empty()) sentences.push_back(row.back());
  return sentences;
}

}  // namespace wetfront::verification
