#include "verification/scene/filling_time.h"
#include "verification/scene/reading.h"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace wetfront::verification {
namespace {

void read_scheme(SectionReader& reader, Stage& stage, const Reading& reading) {
  if (!reading.wet()) {
    reader.unused("scheme", "there is no [water] in this scene", "Remove it, or add [water].");
    return;
  }
  if (!reader.has("scheme")) {  // of no concern to the reference: `wetfront run` asks for it
    if (!reading.has_reference()) reader.missing("scheme", "with [water] the stage must say how the water moves");
    return;
  }
  static const std::map<std::string, Scheme> known = {{"seepage", Scheme::seepage},
                                                      {"semi-implicit", Scheme::semi_implicit},
                                                      {"implicit-drag", Scheme::implicit_drag},
                                                      {"explicit", Scheme::explicit_drag}};
  const std::string scheme = reader.choice("scheme");
  if (scheme == "auto") stage.scheme = Scheme::seepage;
  if (const auto found = known.find(scheme); found != known.end()) stage.scheme = found->second;
}

void read_step_control(SectionReader& reader, Stage& stage, bool elastic) {
  if (stage.scheme == Scheme::seepage) stage.backward_euler = reader.choice("time_integrator") == "backward-euler";
  if (stage.scheme == Scheme::seepage || stage.scheme == Scheme::semi_implicit) {
    stage.time_tolerance = reader.quantity("time_tolerance");
    if (!elastic)
      reader.unused("step_safety", "this scheme has no stability limit", "Remove it; time_tolerance rules its steps.");
  }
  if (stage.scheme == Scheme::implicit_drag || stage.scheme == Scheme::explicit_drag)
    stage.printed_mass_balance = reader.choice("mass_balance") == "printed-2021";
  if (reader.has("largest_step")) stage.largest_step = reader.quantity("largest_step");
  stage.step_safety = reader.quantity("step_safety");
  if (!elastic)
    reader.unused("local_damping", "every soil of this scene is rigid",
                  "Remove it, or give the soil young and poisson.");
  stage.local_damping = reader.quantity("local_damping");
}

/// How the skeleton moves in this stage.
void read_motion(SectionReader& reader, Stage& stage, bool elastic) {
  const std::string motion = reader.choice("skeleton");
  stage.motion.quasi_static = motion == "quasi-static" || (motion.empty() && stage.scheme == Scheme::seepage);
  stage.motion.unbalanced_ratio = reader.quantity("unbalanced_ratio");
  stage.motion.relaxation_damping = reader.quantity("relaxation_damping");
  if (stage.scheme == Scheme::seepage && stage.motion.quasi_static)
    stage.motion.coupling_tolerance = reader.quantity("coupling_tolerance");
  const std::string two_velocities = stage.scheme == Scheme::explicit_drag ? "explicit" : "implicit-drag";
  if (stage.motion.quasi_static && (stage.scheme == Scheme::implicit_drag || stage.scheme == Scheme::explicit_drag))
    reader.complain("skeleton",
                    {"a quasi-static skeleton does not go with " + two_velocities,
                     "two velocities are there for inertia", "Write \"dynamic\", or scheme = \"seepage\"."});
  if (elastic && stage.motion.quasi_static && stage.scheme == Scheme::semi_implicit)
    reader.complain("skeleton",
                    {"a quasi-static skeleton does not go with semi-implicit", "there is no inertia in an equilibrium",
                     "Write \"dynamic\", or scheme = \"seepage\"."});
  if (!elastic)
    for (const char* key : {"skeleton", "unbalanced_ratio", "relaxation_damping", "coupling_tolerance"})
      reader.unused(key, "every soil of this scene is rigid", "Remove it, or give the soil young and poisson.");
  else if (!stage.motion.quasi_static)
    for (const char* key : {"unbalanced_ratio", "relaxation_damping", "coupling_tolerance"})
      reader.unused(key, "this stage is dynamic", "Remove it, or write skeleton = \"quasi-static\".");
}

/// When the stage that is read begins [s]; nothing where that is not known before the run.
std::optional<double> begins(const Reading& reading) {
  const std::vector<Stage>& before = reading.scene.stages;
  return before.empty() ? std::optional(0.0) : seconds_of(before.back().until, reading.filling());
}

void check_end(SectionReader& reader, const Stage& stage, const Reading& reading) {
  const Scene& scene = reading.scene;
  const FillingTime filling = reading.filling();
  if (stage.until.of_filling && !filling.why_not.empty())
    reader.complain("until", {"this scene has no filling time", filling.why_not, "Write a time as in \"1800 s\"."});
  const auto end = seconds_of(stage.until, filling);
  const auto before = begins(reading);
  if (end && before && *end <= *before)
    reader.complain("until",
                    {fmt::format("the stage '{}' ends before it starts", stage.name),
                     fmt::format("it ends at {:.6g} s, and {} {:.6g} s", *end,
                                 scene.stages.empty() ? "the run starts at" : "the stage before ends at", *before),
                     "`until` counts from the start of the run: give a later time."});
}

void read_event(SectionReader& reader, Stage& stage, const Reading& reading) {
  StageEvent& event = stage.event;
  const std::string ends = reader.choice("ends_with");
  if (reader.has("picture_every")) stage.picture_every = reader.quantity("picture_every");
  if (ends == "failure") {
    event.kind = StageEvent::Kind::failure;
    event.displacement = reader.quantity("failure_displacement");
    event.unbalanced_ratio = reader.quantity("failure_ratio");
    event.shortest_step = reader.quantity("shortest_step");
    if (!stage.motion.quasi_static)
      reader.complain("ends_with", {"a dynamic stage does not end with failure", "its skeleton moves all the time",
                                    "Write skeleton = \"quasi-static\", or ends_with = \"rest\"."});
  }
  if (ends == "rest") {
    event.kind = StageEvent::Kind::rest;
    event.energy_ratio = reader.quantity("rest_energy");
    event.hold = reader.quantity("rest_hold");
    if (stage.motion.quasi_static)
      reader.complain("ends_with", {"a quasi-static stage does not end with rest", "its skeleton is always at rest",
                                    "Write skeleton = \"dynamic\", or ends_with = \"failure\"."});
  }
  if (!reading.elastic())
    for (const char* key : {"ends_with", "picture_every"})
      reader.unused(key, "every soil of this scene is rigid", "Remove it, or give the soil young and poisson.");
}

/// `until` or `lasts`; false where neither can be used.
bool read_end(SectionReader& reader, Stage& stage, const Reading& reading) {
  const auto until = reader.time("until");
  if (reader.has("lasts")) {
    if (reader.has("until"))
      reader.complain("lasts", {"lasts is given beside until", "they say the same thing in two ways", "Keep one."});
    stage.lasts = reader.quantity("lasts");
    stage.until = {*stage.lasts, false, reader.origin_of("lasts")};
    if (const auto before = begins(reading)) stage.until.value += *before;
    return true;
  }
  if (!reader.has("until")) reader.missing("until", "end of the stage since the start of the run");
  if (!until) return false;
  stage.until = *until;
  check_end(reader, stage, reading);
  return true;
}

}  // namespace

void read_stages(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "stage", reading.complaints)) {
    Stage stage;
    stage.name = reader.text("name");
    stage.origin = reader.origin();
    read_scheme(reader, stage, reading);
    read_step_control(reader, stage, reading.elastic());
    read_motion(reader, stage, reading.elastic());
    read_event(reader, stage, reading);
    if (read_end(reader, stage, reading)) reading.scene.stages.push_back(stage);
    reader.finish();
  }
  read_mpm(reading);
}

}  // namespace wetfront::verification
