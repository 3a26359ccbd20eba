#include "verification/scene/filling_time.h"
#include "verification/scene/reading.h"

#include <fmt/format.h>

#include <cmath>

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
  const std::string scheme = reader.choice("scheme");
  if (scheme == "seepage") stage.scheme = Scheme::seepage;
  if (scheme == "implicit-drag") stage.scheme = Scheme::implicit_drag;
}

void read_step_control(SectionReader& reader, Stage& stage, bool elastic) {
  if (stage.scheme == Scheme::seepage) {
    stage.backward_euler = reader.choice("time_integrator") == "backward-euler";
    stage.time_tolerance = reader.quantity("time_tolerance");
    if (!elastic)
      reader.unused("step_safety", "seepage has no stability limit", "Remove it; time_tolerance rules its steps.");
  }
  if (stage.scheme == Scheme::implicit_drag)
    stage.printed_mass_balance = reader.choice("mass_balance") == "printed-2021";
  if (reader.has("largest_step")) stage.largest_step = reader.quantity("largest_step");
  stage.step_safety = reader.quantity("step_safety");
  if (!elastic)
    reader.unused("local_damping", "every soil of this scene is rigid",
                  "Remove it, or give the soil young and poisson.");
  stage.local_damping = reader.quantity("local_damping");
}

void check_end(SectionReader& reader, const Stage& stage, const Reading& reading) {
  const Scene& scene = reading.scene;
  const FillingTime filling = reading.filling();
  if (stage.until.of_filling && !filling.why_not.empty())
    reader.complain("until", {"this scene has no filling time", filling.why_not, "Write a time as in \"1800 s\"."});
  const auto end = seconds_of(stage.until, filling);
  const auto before = scene.stages.empty() ? std::optional(0.0) : seconds_of(scene.stages.back().until, filling);
  if (end && before && *end <= *before)
    reader.complain("until",
                    {fmt::format("the stage '{}' ends before it starts", stage.name),
                     fmt::format("it ends at {:.6g} s, and {} {:.6g} s", *end,
                                 scene.stages.empty() ? "the run starts at" : "the stage before ends at", *before),
                     "`until` counts from the start of the run: give a later time."});
}

}  // namespace

void read_stages(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "stage", reading.complaints)) {
    Stage stage;
    stage.name = reader.text("name");
    stage.origin = reader.origin();
    read_scheme(reader, stage, reading);
    read_step_control(reader, stage, reading.elastic());
    if (const auto until = reader.time("until")) {
      stage.until = *until;
      check_end(reader, stage, reading);
      reading.scene.stages.push_back(stage);
    }
    reader.finish();
  }
  if (auto section = section_of(reading.root, "mpm", reading.complaints)) {
    const int points = section->count("points_per_cell");
    const int root = static_cast<int>(std::lround(std::sqrt(points)));
    if (points > 0 && root * root != points)
      section->complain("points_per_cell", {section->shown("points_per_cell") + " is not a square number",
                                            "points stand in rows and columns of a cell", "Write 1, 4, 9 or 16."});
    reading.scene.mpm = {points, section->origin()};
    section->finish();
  }
}

}  // namespace wetfront::verification
