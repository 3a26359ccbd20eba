// The ledger of effects, as a page and as sentences.
#include "reports/write.h"
#include "verification/study/effects.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace wetfront::verification {
namespace {

constexpr const char* table_title = "Effects";
constexpr double shown_from = 1e-3;  ///< of the tolerance: what is smaller decides nothing

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

double ratio(const Influence& one) {
  return std::abs(one.change) / std::max(one.tolerance, 1e-300);
}

/// The outcome on which a verdict rests: of those that share it the one that changes most in terms of its tolerance;
/// an event that is there or not is beyond any change.
const Influence& deciding(const std::vector<Influence>& all) {
  const Need need = overall_need(all);
  return *std::ranges::max_element(all, {}, [need](const Influence& one) {
    return std::pair(one.need == need, std::isnan(one.change) ? 1e300 : ratio(one));
  });
}

/// "-" for what is not there.
std::string cell(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

/// How an event that is there or not stands in the column of changes.
std::string change_text(const Influence& one) {
  return one.vanishes ? "no more" : one.appears ? "only then" : cell(one.change, 4);
}

/// Outcomes as the reader of a sentence wants them: "time of ponding" and not "p > 0.2 kPa at probe base" alone.
std::string named(const std::string& outcome) {
  return outcome.starts_with("p > ") ? "the time when " + outcome : outcome;
}

std::string unit_behind(const Influence& one) {
  return one.unit == "-" ? "" : " " + one.unit;
}

/// "changes from 0.29 to 0.31 m, 1.4 times what is tolerated".
std::string change_of(const Influence& one) {
  const auto number = [](double value) { return fmt::format("{:.4g}", value); };
  const std::string from = number(one.value), to = number(one.value + one.change);
  const std::string unit = unit_behind(one);
  std::string text = from == to ? fmt::format("changes by {:.2g}{}", one.change, unit)
                                : fmt::format("changes from {} to {}{}", from, to, unit);
  if (!one.gated) return text + fmt::format(" ({:.3g}{} would be noticed)", one.tolerance, unit);
  return text + (ratio(one) < 0.01 ? ", less than a hundredth of what is tolerated"
                                   : fmt::format(", {:.2g} times what is tolerated", ratio(one)));
}

/// What changes beside an event that is there or not; "" where nothing can be told.
std::string beside_event(std::vector<Influence> all) {
  std::erase_if(all, [](const Influence& one) { return std::isnan(one.change); });
  if (all.empty()) return "";
  const Influence& most = deciding(all);
  return fmt::format(" Of what is there with and without it {} {}.", named(most.outcome), change_of(most));
}

/// What is to be said of the other outcomes.
std::string others(const std::vector<Influence>& all) {
  if (all.size() < 2) return "";
  const Need need = overall_need(all);
  if (need == Need::not_needed) return "; other outcomes by less";
  const auto same = std::ranges::count(all, need, &Influence::need) - 1;
  return same == 0 ? "; no other outcome says so"
                   : fmt::format("; so do {} of {} other outcomes", same, all.size() - 1);
}

std::string share(double with, double without) {
  return with > 0 ? fmt::format("{:.1f}", 100 * (with - without) / with) : "-";
}

}  // namespace

std::string effect_sentence(const EffectChange& change, const PointResult& result, const std::vector<Influence>& all) {
  std::string subject = change.effect;
  subject[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(subject[0])));
  if (!change.by_nature.empty()) return subject + " is needed: " + change.by_nature + ".";
  if (result.left_out())
    return fmt::format("{} was not tried: about {:.3g} CPU-s, more than --budget, on four times as large cells, too.",
                       subject, result.expected_cpu);
  if (all.empty()) return subject + " could not be tried: " + result.message;
  const Influence& most = deciding(all);
  const Need need = overall_need(all);
  const std::string doing = change.called_for ? "Without it" : "With it";
  std::string text =
      subject + (need == Need::needed       ? (change.called_for ? " is needed. " : " is missing. ")
                 : need == Need::not_needed ? (change.called_for ? " could be left out. " : " is not needed. ")
                                            : ": undecided. ");
  if (most.vanishes)
    text += fmt::format("{} there is no {} any more.{}", doing, named(most.outcome), beside_event(all));
  else if (most.appears)
    text += fmt::format("{} there is a {}, otherwise none.{}", doing, named(most.outcome), beside_event(all));
  else
    text += fmt::format("{} {} {}{}.", doing, named(most.outcome), change_of(most), others(all));
  if (need == Need::undecided && !std::isnan(most.change))
    text += fmt::format(" Finer cells change it by {:.2g}{}.", most.uncertainty, unit_behind(most));
  if (change.cells != 1) text += fmt::format(" (Tried on cells {:g} times as large, for its cost.)", 1 / change.cells);
  return text;
}

reports::Record effects_page(const Scene& scene, const std::vector<EffectChange>& changes,
                             const std::vector<PointResult>& results, const std::filesystem::path& out) {
  reports::Record record = start_study("which effects matter", scene, results);
  record.verdict = reports::Verdict::info;
  reports::Table summary{table_title,
                         "Verdicts",
                         "Share of time and memory: what the run without the effect saves of the run with it.",
                         {"effect", "in the scene", "verdict", "time [%]", "point memory [%]", "what the scene needs"},
                         {}};
  reports::Table detail{
      "Influence on each outcome",
      "Influence",
      fmt::format("Change: with the effect left out or added, on the same cells. Doubt: the change that "
                  "finer cells make. Changes below {:g} of the tolerance are left out.",
                  shown_from),
      {"effect", "outcome", "unit", "change", "doubt", "tolerance", "verdict"},
      {}};
  for (std::size_t i = 2; i < changes.size(); ++i) {
    if (changes[i].how.empty()) continue;  // the scene on other cells
    const PointResult &base = results[changes[i].base], &finer = results[changes[i].base == 0 ? 1 : 0];
    const auto all =
        results[i].left_out() ? std::vector<Influence>{} : influences(scene, base, finer, results[i], changes[i].cells);
    const bool called = changes[i].called_for, known = !all.empty();
    const auto part = [&](double scene_has, double changed) {
      return !known ? std::string("-") : called ? share(scene_has, changed) : share(changed, scene_has);
    };
    const Need need = changes[i].by_nature.empty() ? overall_need(all) : Need::needed;
    summary.rows.push_back({changes[i].effect, called ? "yes" : "no", word(need),
                            part(base.candidate_cpu, results[i].candidate_cpu),
                            part(static_cast<double>(base.point_bytes), static_cast<double>(results[i].point_bytes)),
                            effect_sentence(changes[i], results[i], all)});
    summary.links.push_back(results[i].left_out() ? "" : link_to(out, i, changes[i].point));
    for (const Influence& one : all)
      if (!(std::abs(one.change) < shown_from * one.tolerance))
        detail.rows.push_back({changes[i].effect, one.outcome, one.unit, change_text(one), cell(one.uncertainty, 2),
                               cell(one.tolerance, 3), word(one.need)});
  }
  for (const InseparableEffect& one : inseparable_effects(scene)) {
    std::string subject = one.effect;
    subject[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(subject[0])));
    summary.rows.push_back({one.effect, one.called_for ? "yes" : "no", "not separable", "-", "-",
                            subject + " is not separable here, because " + one.why + "."});
    summary.links.push_back("");
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
