#include "verification/translate/mpm_lacks.h"

namespace wetfront::verification {

std::vector<std::string> mpm_lacks(const Scene& scene) {
  std::vector<std::string> messages;
  if (scene.geometry.dim() == 3)
    messages.push_back(scene.geometry.origin.text() +
                       ": this ground is three-dimensional (the material point method of this version has no third "
                       "dimension in scenes). Use 'wetfront reference' for this scene, or describe a section of it.");
  if (scene.water)
    for (const Stage& stage : scene.stages)
      if (!stage.scheme)
        messages.push_back(stage.origin.text() + ": the stage '" + stage.name +
                           "' has no scheme (the material point method must know how the water moves). Add scheme = "
                           "\"auto\", or use 'wetfront reference' for this scene.");
  return messages;
}

}  // namespace wetfront::verification
