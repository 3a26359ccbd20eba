#include "verification/ledger/rerun_scene.h"

#include "verification/run/finer_cells.h"
#include "verification/run/run_scene.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"

#include <cmath>

namespace wetfront::verification {
namespace {

/// What Richards' equation knows: water without inertia in a rigid skeleton.
Scene without_what_richards_lacks(Scene scene) {
  for (Stage& stage : scene.stages) {
    stage.scheme = Scheme::seepage;
    stage.motion = {};
    stage.printed_mass_balance = false;
  }
  for (Soil& soil : scene.soils) soil.elastic.reset(), soil.strength.reset();
  for (Boundary& boundary : scene.boundaries) boundary.skeleton = {}, boundary.load.reset(), boundary.traction.reset();
  scene.skeleton = {};
  return scene;
}

/// Errors of the time integration several times smaller: by a tenth of the tolerance, by steps a quarter as long where
/// they are given, half as long at a limit.
void refine_steps(mpm::Problem<2>& problem, int times) {
  for (mpm::Stage& stage : problem.stages) {
    stage.time_tolerance = std::max(1e-11, stage.time_tolerance * std::pow(10.0, -times));
    stage.largest_step *= std::pow(4.0, -times);
    stage.step_safety *= std::pow(2.0, -times);
  }
}

}  // namespace

CandidateRunner rerun_scene(const Scene& scene, const Timeline& timeline,
                            std::function<void(mpm::Problem<2>&)> change) {
  if (std::holds_alternative<MeshFile>(scene.geometry.shape)) return {};
  return [&scene, &timeline, change = std::move(change)](const Rerun& rerun) {
    Scene asked = with_finer_cells(scene, 1 << rerun.finer_cells);
    if (rerun.richards_only) asked = without_what_richards_lacks(std::move(asked));
    mpm::Problem<2> problem = to_mpm(asked, mpm_mesh(asked), timeline);
    refine_steps(problem, rerun.finer_steps);
    if (!rerun.times.empty()) problem.output_times = rerun.times;
    if (change) change(problem);
    return solve_candidate(problem);
  };
}

}  // namespace wetfront::verification
