#include "verification/scene/reading.h"

#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

int read_points(SectionReader& reader) {
  const int points = reader.count("points_per_cell");
  const int root = static_cast<int>(std::lround(std::sqrt(points)));
  if (points > 0 && root * root != points)
    reader.complain("points_per_cell", {reader.shown("points_per_cell") + " is not a square number",
                                        "points stand in rows and columns of a cell", "Write 1, 4, 9 or 16."});
  return points;
}

RainEntry read_rain_entry(SectionReader& reader) {
  static const std::map<std::string, RainEntry> known = {{"standard", RainEntry::standard},
                                                         {"martinelli-2020", RainEntry::martinelli_2020},
                                                         {"bandara-2016", RainEntry::bandara_2016},
                                                         {"consistent-flux", RainEntry::consistent_flux}};
  const auto found = known.find(reader.choice("rainfall"));
  return found == known.end() ? RainEntry::standard : found->second;
}

/// The topmost row of cells reaches above the ground: only where that row is known and rained on as a whole.
void check_surface(SectionReader& reader, double fraction, const Scene& scene) {
  if (!(fraction < 1)) return;
  const Geometry& geometry = scene.geometry;
  if (geometry.dim() != 2)
    reader.complain("surface_in_cell", {"this ground has no topmost row of cells that could be cut",
                                        "it is a mesh of your own or a box in space", "Remove it."});
  if (!geometry.layers.empty())
    reader.complain("surface_in_cell", {"cells of this ground follow its layers",
                                        "the topmost ones could not be cut without moving the layers in them",
                                        "Remove it, or describe the soils by zones."});
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape); profile && profile->room > 0)
    reader.complain("surface_in_cell",
                    {"this profile has room above its ground", "the surface of a body that may move follows cells",
                     "Remove it, or remove room."});
  for (const SidePart& part : geometry.parts)
    if (part.of == "top")
      reader.complain("surface_in_cell",
                      {"the part '" + part.name + "' is cut out of the top",
                       "a surface inside cells is one side, found from the points", "Remove the one or the other."});
}

}  // namespace

void read_mpm(Reading& reading) {
  auto section = section_of(reading.root, "mpm", reading.complaints);
  if (!section) return;
  MpmSettings& mpm = reading.scene.mpm;
  mpm.origin = section->origin();
  mpm.points_per_cell = read_points(*section);
  mpm.surface_in_cell = section->quantity("surface_in_cell");
  mpm.water_softening = section->quantity("water_softening");
  if (section->has("water_softening") && !reading.scene.water)
    section->unused("water_softening", "there is no [water] in this scene", "Remove it.");
  mpm.threads = section->count("threads");
  check_surface(*section, mpm.surface_in_cell, reading.scene);
  mpm.rain_entry = read_rain_entry(*section);
  if (section->has("accuracy")) mpm.accuracy = section->quantity("accuracy");
  mpm.cpu_budget = section->quantity("cpu_budget");
  section->finish();
}

}  // namespace wetfront::verification
