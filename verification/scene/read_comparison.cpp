#include "verification/scene/filling_time.h"
#include "verification/scene/quantities.h"
#include "verification/scene/reading.h"
#include "verification/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetfront::verification {
namespace {

/// Cells of the reference where the scene does not say: enough for a column, those of the shape for any other.
int own_cells(const Geometry& geometry) {
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) return slope->cells_over;
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) return profile->cells_over;
  if (const auto* box = std::get_if<Box>(&geometry.shape)) return box->cells.empty() ? 1 : box->cells.back();
  if (std::holds_alternative<MeshFile>(geometry.shape)) return 1;
  return ReferenceSettings{}.cells;
}

void read_reference(Reading& reading) {
  auto section = section_of(reading.root, "reference", reading.complaints);
  if (!section) return;
  if (!reading.wet())
    section->complain_at(section->place(),
                         {"[reference] is not used", "there is no [water], and the reference computes nothing else",
                          "Remove it, or add [water]."});
  const auto& g = reading.scene.gravity;
  if (reading.wet() && g[0] == 0 && g[1] == 0 && g[2] == 0)
    section->complain_at(section->place(),
                         {"[reference] needs gravity", "it computes with heads, p / (rho g), and g is zero here",
                          "Remove [reference] and its gates, or let gravity act."});
  ReferenceSettings settings;
  settings.origin = section->origin();
  settings.cells = section->has("cells") ? section->count("cells") : own_cells(reading.scene.geometry);
  settings.tolerance = section->quantity("tolerance");
  const std::string integrator = section->choice("integrator"), skeleton = section->choice("skeleton_storage");
  if (integrator == "backward-euler") settings.integrator = ReferenceSettings::Integrator::backward_euler;
  if (integrator == "dirk") settings.integrator = ReferenceSettings::Integrator::dirk;
  settings.degree = section->count("degree");
  if (auto adaptive = section->table("adaptive")) {
    settings.adaptive = AdaptiveMesh{adaptive->count("levels"), adaptive->quantity("threshold")};
    if (std::holds_alternative<Column>(reading.scene.geometry.shape))
      section->complain("adaptive", {"a column is not refined adaptively", "its reference is one-dimensional and cheap",
                                     "Remove it; cells says how fine the column is."});
    adaptive->finish();
  }
  if (skeleton == "saturation") settings.skeleton = ReferenceSettings::SkeletonStorage::saturation;
  if (skeleton == "effective-saturation") settings.skeleton = ReferenceSettings::SkeletonStorage::effective_saturation;
  const std::string other = skeleton == "saturation" ? "effective-saturation" : "saturation";
  for (const Soil& soil : reading.scene.soils)
    if (skeleton != "none" && soil.elastic &&
        (soil.bishop == Bishop::effective_saturation) != (skeleton == "effective-saturation"))
      section->complain("skeleton_storage",
                        {"the soil '" + soil.name + "' has bishop = \"" + other + "\"",
                         "its storage follows from its own effective stress", "Write the same of both."});
  if (section->has("skeleton_storage") && skeleton != "none" && !reading.elastic())
    section->unused("skeleton_storage", "every soil of this scene is rigid",
                    "Remove it, or give the soil young and poisson.");
  reading.scene.reference = settings;
  section->finish();
}

void check_times(SectionReader& section, const Scene& scene, const FillingTime& filling) {
  std::optional<double> end, before;
  for (const Stage& stage : scene.stages) end = std::max(end, seconds_of(stage.until, filling));
  bool said = false;
  for (const SceneTime& time : scene.comparison.times) {
    const Place place{time.origin.line, time.origin.column};
    if (time.of_filling && !filling.why_not.empty() && !std::exchange(said, true))
      section.complain_at(place, {"this scene has no filling time", filling.why_not, "Write a time as in \"1800 s\"."});
    const auto seconds = seconds_of(time, filling);
    if (seconds && end && *seconds > *end * (1 + 1e-12))
      section.complain_at(place, {fmt::format("the comparison at {:.6g} s is never reached", *seconds),
                                  fmt::format("the last stage ends at {:.6g} s", *end),
                                  "Compare earlier, or let the last stage run on."});
    if (seconds && before && *seconds <= *before)
      section.complain_at(
          place, {"the comparison times do not ascend", fmt::format("{:.6g} s follows {:.6g} s", *seconds, *before),
                  "Sort them, each time once."});
    before = seconds;
  }
}

/// The allowed error in the unit of the quantity; NaN when wrong.
double read_value(SectionReader& reader, const Quantity* quantity) {
  const Value* written = reader.raw("value");
  if (!written || !quantity) return std::nan("");
  const double value = reader.item_quantity("value", *written, quantity->unit);
  if (value <= 0)
    reader.complain("value", {reader.shown("value") + " lets nothing pass", "an error is never below zero",
                              "Write a positive value."});
  if (quantity->unit == "1" && value > 1)
    reader.complain("value", {reader.shown("value") + " gates nothing",
                              "a relative error of more than 100 % would pass", "Write percent as in \"1 %\"."});
  return value;
}

void check_time(SectionReader& reader, const Tolerance& gate, const Quantity& quantity, const Reading& reading) {
  if (!gate.at) return;
  if (quantity.per != Quantity::Per::time)
    return reader.unused("at",
                         gate.quantity + " is one value per " + (quantity.per == Quantity::Per::run ? "run" : "probe"),
                         "Remove it.");
  const Scene& scene = reading.scene;
  const FillingTime filling = reading.filling();
  const auto at = seconds_of(*gate.at, filling);
  const bool listed =
      std::any_of(scene.comparison.times.begin(), scene.comparison.times.end(), [&](const SceneTime& time) {
        const auto seconds = seconds_of(time, filling);
        return !at || !seconds || std::abs(*seconds - *at) <= 1e-9 * std::abs(*at);
      });
  if (!listed)
    reader.complain("at", {reader.shown("at") + " is no comparison time", "nothing is compared then",
                           "Add it to the times of [comparison]."});
}

void check_probe(SectionReader& reader, const Tolerance& gate, const Quantity& quantity, const Scene& scene) {
  if (quantity.per != Quantity::Per::probe)
    return reader.unused("probe", gate.quantity + " is not measured at a probe", "Remove it.");
  std::vector<std::string> names;
  for (const Probe& probe : scene.probes) names.push_back(probe.name);
  if (names.empty())
    reader.complain("quantity", {gate.quantity + " needs a probe", "the scene has no [[probe]]", "Add one."});
  else if (!gate.probe.empty() && std::find(names.begin(), names.end(), gate.probe) == names.end())
    reader.complain("probe", {"there is no probe '" + gate.probe + "'", "the scene has " + alternatives(names),
                              suggest(gate.probe, names)});
}

/// [comparison] has been read before.
void check_second_mesh(SectionReader& reader, const Tolerance& gate, const Scene& scene) {
  if (gate.quantity != "failure_time_mesh") return;
  const auto fails = [](const Stage& stage) { return stage.event.kind == StageEvent::Kind::failure; };
  if (scene.comparison.second_mesh == 1)
    reader.complain("quantity", {gate.quantity + " is never evaluated", "the scene runs on one mesh alone",
                                 "Add second_mesh = \"coarser\" to [comparison]."});
  else if (std::ranges::none_of(scene.stages, fails))
    reader.complain("quantity", {gate.quantity + " is never evaluated", "no stage of this scene ends with failure",
                                 "Remove this gate, or add ends_with = \"failure\" to a stage."});
}

void read_tolerance(SectionReader& reader, Reading& reading) {
  Scene& scene = reading.scene;
  Tolerance gate;
  gate.quantity = reader.choice("quantity");
  gate.at = reader.time("at");
  gate.probe = reader.text("probe");
  gate.reason = reader.text("reason");
  gate.origin = reader.origin();
  const Quantity* quantity = find_quantity(gate.quantity);
  if (!reading.has_reference() && quantity != nullptr && !quantity->own)
    reader.complain_at(reader.place(), {"this gate is not used", "without [reference] nothing is compared",
                                        "Remove it, or add [reference]."});
  gate.value = read_value(reader, quantity);
  if (quantity) {
    check_time(reader, gate, *quantity, reading);
    check_probe(reader, gate, *quantity, scene);
    check_second_mesh(reader, gate, scene);
    const FillingTime filling = reading.filling();
    if (quantity->needs_filling_time && !filling.why_not.empty())
      reader.complain("quantity", {"this scene has no filling time", filling.why_not, "Remove this gate."});
    if (quantity->per == Quantity::Per::time && !reading.root.find("comparison"))
      reader.complain("quantity", {gate.quantity + " is never evaluated", "the scene has no comparison times",
                                   "Add [comparison] with times."});
  }
  scene.comparison.tolerances.push_back(gate);
  reader.finish();
}

void read_second_mesh(SectionReader& section, Scene& scene) {
  const std::string cells = section.choice("second_mesh");
  if (cells == "coarser") scene.comparison.second_mesh = 0.5;
  if (cells == "finer") scene.comparison.second_mesh = 2;
  if (scene.comparison.second_mesh == 1) return;
  if (std::holds_alternative<MeshFile>(scene.geometry.shape))
    section.complain("second_mesh", {"a mesh of your own has no second one", "its cells cannot be changed by the scene",
                                     "Remove it, and run the scene with two mesh files."});
  if (!has_events(scene))
    section.unused("second_mesh", "no stage of this scene ends with failure or rest, so nothing comes out of a slide",
                   "Remove it; `wetfront study accuracy` tells what cells cost.");
}

void read_observation(SectionReader& reader, Scene& scene) {
  Observation known{reader.text("quantity"), reader.text("measured"), reader.text("simulated"), reader.text("remark"),
                    reader.origin()};
  std::vector<std::string> names = {"failure_time", "slide_duration", "largest_displacement", "largest_velocity"};
  for (const Probe& probe : scene.probes) {
    names.push_back("arrival_time:" + probe.name);
    names.push_back("rise_rate:" + probe.name);
    for (const Probe& other : scene.probes)
      if (other.name != probe.name) names.push_back("interval:" + probe.name + ":" + other.name);
  }
  if (!known.quantity.empty() && std::find(names.begin(), names.end(), known.quantity) == names.end())
    reader.complain("quantity", {"nothing here is called '" + known.quantity + "'", "there is " + alternatives(names),
                                 suggest(known.quantity, names)});
  scene.observations.push_back(known);
  reader.finish();
}

}  // namespace

void read_comparison(Reading& reading) {
  read_reference(reading);
  if (auto section = section_of(reading.root, "comparison", reading.complaints)) {
    reading.scene.comparison.times = section->times("times");
    reading.scene.comparison.origin = section->origin();
    check_times(*section, reading.scene, reading.filling());
    read_second_mesh(*section, reading.scene);
    section->finish();
  }
  for (SectionReader& reader : sections_of(reading.root, "tolerance", reading.complaints))
    read_tolerance(reader, reading);
  for (SectionReader& reader : sections_of(reading.root, "observed", reading.complaints))
    read_observation(reader, reading.scene);
}

}  // namespace wetfront::verification
