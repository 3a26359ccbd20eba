#include "verification/run/scene_record.h"

#include "verification/run/provenance.h"
#include "verification/run/run_scene.h"

namespace wetfront::verification {

reports::Record record_of(const Scene& scene, const meshes::Mesh& mesh) {
  reports::Record record;
  record.case_name = case_name(scene.path);
  record.title = scene.title;
  record.requirement = scene.requirement;
  record.scene_path = scene.path.string();
  record.scene_text = scene.text;
  record.provenance = provenance(scene.text, mesh, scene.mpm.threads);
  return record;
}

}  // namespace wetfront::verification
