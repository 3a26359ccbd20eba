#include "verification/study/scheme_settings.h"

#include "verification/scene/keys.h"

#include <algorithm>

namespace wetfront::verification {

bool controls_its_error(const std::string& scheme) {
  return scheme == "seepage" || scheme == "semi-implicit";
}

std::string last_stage(const Scene& scene) {
  return "stage[" + std::to_string(scene.stages.size() - 1) + "].";
}

std::vector<Setting> scheme_settings(const Scene& scene, const std::string& scheme, const std::string& integrator) {
  const std::string stage = last_stage(scene);
  std::vector<Setting> settings;
  for (const Key* key : keys_of("stage"))  // what counts with other schemes only
    if (key->with_key == "scheme" && std::ranges::find(key->with_choices, scheme) == key->with_choices.end())
      settings.push_back({stage + key->name, ""});
  settings.push_back({stage + "time_integrator", integrator});
  if (!controls_its_error(scheme)) {
    if (deforms(scene) && scene.stages.back().motion.quasi_static) {
      for (const char* key : {"coupling_tolerance", "unbalanced_ratio", "relaxation_damping"})
        settings.push_back({stage + key, ""});
      settings.push_back({stage + "skeleton", "dynamic"});
      // Without it the soil's weight would fall on the full pores at once (180 kPa at the base of a column of 1.2 m).
      if (scene.stages.size() == 1) settings.push_back({"skeleton.initial_stress", "k0"});
    }
  }
  settings.push_back({stage + "scheme", scheme});
  return settings;
}

}  // namespace wetfront::verification
