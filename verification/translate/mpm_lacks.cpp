#include "verification/translate/mpm_lacks.h"

namespace wetfront::verification {
namespace {

class Lacks {
 public:
  void add(const Origin& origin, const std::string& what, const std::string& lacking) {
    messages.push_back(origin.text() + ": " + what + " (the material point method of this version has no " + lacking +
                       "). Use 'wetfront reference' for this scene, or leave it out.");
  }
  std::vector<std::string> messages;
};

void check_soil(const Soil& soil, Lacks& lacks) {
  const std::string name = "the soil '" + soil.name + "'";
  if (soil.retention && soil.retention->index() > 1)
    lacks.add(soil.origin, name + " has a retention curve other than van-genuchten or exponential", "other curve");
  if (const auto* law = soil.retention ? std::get_if<VanGenuchten>(&*soil.retention) : nullptr; law && law->cut_off > 0)
    lacks.add(soil.origin, name + " has a cut-off at air entry", "cut-off");
  if (soil.permeability > PermeabilityLaw::constant)
    lacks.add(soil.origin, name + " has a relative permeability of haverkamp, broadbridge-white or points", "such law");
  if (soil.anisotropy) lacks.add(soil.anisotropy->origin, name + " is anisotropic", "anisotropy");
  if (soil.conductivity_field)
    lacks.add(soil.origin, name + " has a field of conductivities", "conductivity that varies inside a soil");
  if (soil.specific_storage)
    lacks.add(soil.origin, name + " has a specific storage", "storage other than that of the water's bulk modulus");
}

void check_boundary(const Boundary& boundary, Lacks& lacks) {
  const std::string side = "'" + boundary.side + "'";
  if (!boundary.water) return;
  switch (*boundary.water) {
    case WaterCondition::total_head:
      return lacks.add(boundary.origin, side + " has a prescribed total head", "pressure that varies along a side");
    case WaterCondition::flux:
      return lacks.add(boundary.origin, side + " has a prescribed flux", "flux per area of a side");
    case WaterCondition::water_level:
      return lacks.add(boundary.origin, side + " has a water level in front of it", "water level");
    case WaterCondition::as_at_start:
      return lacks.add(boundary.origin, side + " keeps the pressure of the start", "pressure that varies along a side");
    case WaterCondition::periodic:
      return lacks.add(boundary.origin, side + " is periodic with '" + boundary.partner + "'", "periodic sides");
    case WaterCondition::pressure:
      if (boundary.record.value.size() > 1)
        lacks.add(boundary.origin, side + " has a pressure that changes in time", "such pressure");
      return;
    default:
      return;
  }
}

}  // namespace

std::vector<std::string> mpm_lacks(const Scene& scene) {
  Lacks lacks;
  if (scene.geometry.dim() == 3)
    lacks.add(scene.geometry.origin, "this ground is three-dimensional", "third dimension");
  for (const Soil& soil : scene.soils) check_soil(soil, lacks);
  for (const Evaporation& evaporation : scene.evaporations)
    lacks.add(evaporation.origin, "water evaporates from '" + evaporation.side + "'", "evaporation");
  for (const Boundary& boundary : scene.boundaries) check_boundary(boundary, lacks);
  if (scene.water)
    for (const Stage& stage : scene.stages)
      if (!stage.scheme)
        lacks.messages.push_back(
            stage.origin.text() + ": the stage '" + stage.name +
            "' has no scheme (the material point method must know how the water moves). Add scheme "
            "= \"seepage\", or use 'wetfront reference' for this scene.");
  return lacks.messages;
}

}  // namespace wetfront::verification
