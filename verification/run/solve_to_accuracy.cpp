#include "verification/run/solve_to_accuracy.h"

#include "verification/compare/profile.h"
#include "verification/run/finer_cells.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_mpm.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr int most_halvings = 6;
constexpr int most_tightenings = 4;
/// The share of the error left to the time integration: small beside that of the mesh, which costs more to shrink.
constexpr double share_of_time = 0.25;

/// Largest relative L2 difference of pressure over the snapshots that both reached, in the cells of `coarse`.
double change_between(const meshes::FieldHistory& coarse, const meshes::FieldHistory& fine) {
  const bool one_mesh = coarse.mesh.cells.size() == fine.mesh.cells.size();
  const auto of_coarse = cell_profiles(coarse),
             of_fine = one_mesh ? cell_profiles(fine) : profiles_at_cells(fine, coarse);
  const auto weight = cell_weights(coarse.mesh, fine.mesh);
  double largest = 0;
  for (std::size_t t = 0; t < std::min(of_coarse.size(), of_fine.size()); ++t)
    largest = std::max(largest, relative_l2(of_coarse[t].pressure, of_fine[t].pressure, weight));
  return coarse.snapshots.size() == fine.snapshots.size() ? largest : std::numeric_limits<double>::infinity();
}

class Search {
 public:
  Search(const Scene& scene, const Timeline& timeline, double accuracy)
      : scene_(scene), timeline_(timeline), accuracy_(accuracy) {}

  AccurateCandidate run() {
    take(attempt(scene_, 0));
    for (int halvings = 1; halvings <= most_halvings && sound(); ++halvings) {
      const Scene finer = with_finer_cells(scene_, 1 << halvings);
      Attempt next = attempt(finer, halvings);
      best_.estimate = next.change;
      if (2 * next.change <= accuracy_) {  // the coarser one is twice as far off at most, at first order
        best_.estimate = 2 * next.change;
        break;
      }
      take(std::move(next));
      cells_ = finer;
      if (best_.estimate <= accuracy_) break;
    }
    tighten();
    best_.accuracy = accuracy_;
    best_.reached = sound() && best_.estimate <= accuracy_;
    best_.summary =
        fmt::format("accuracy {:.3g} % was asked for; after {} runs the MPM's own error is estimated at {:.3g} %{}",
                    100 * accuracy_, best_.tries.size(), 100 * best_.estimate, best_.reached ? "" : ": NOT reached");
    return std::move(best_);
  }

 private:
  struct Attempt {
    mpm::Problem<2> problem;
    Solved solved;
    double change;
    int halvings = 0;
  };

  bool sound() const { return best_.solved.gave_up.empty(); }

  Attempt attempt(const Scene& scene, int halvings) {
    Attempt out{to_mpm(scene, mpm_mesh(scene), timeline_), {}, std::numeric_limits<double>::infinity()};
    out.solved = solve_candidate(out.problem);
    if (!best_.tries.empty()) out.change = change_between(best_.solved.history, out.solved.history);
    best_.tries.push_back(
        {fmt::format("cells / {}, time tolerance {:.1g}", 1 << halvings, scene.stages[0].time_tolerance), out.change,
         out.solved.history.cpu_seconds});
    out.halvings = halvings;
    return out;
  }
  void take(Attempt attempt) {
    halvings_ = attempt.halvings;
    best_.problem = std::move(attempt.problem);
    best_.solved = std::move(attempt.solved);
  }

  /// Schemes with a tolerance only; the others take steps at their stability limit.
  void tighten() {
    const bool controlled = std::ranges::all_of(scene_.stages, [](const Stage& stage) {
      return stage.scheme == Scheme::seepage || stage.scheme == Scheme::semi_implicit;
    });
    for (int i = 0; controlled && i < most_tightenings && sound(); ++i) {
      for (Stage& stage : cells_.stages) stage.time_tolerance /= 10;
      Attempt next = attempt(cells_, halvings_);
      if (!next.solved.gave_up.empty()) {  // the run that there is stands, of an error in time that is not known
        best_.estimate = std::numeric_limits<double>::infinity();
        break;
      }
      const bool settled = next.change <= share_of_time * accuracy_;
      best_.estimate += settled ? next.change : 0;
      if (settled) break;
      take(std::move(next));
    }
  }

  const Scene& scene_;
  const Timeline& timeline_;
  double accuracy_;
  Scene cells_ = scene_;
  int halvings_ = 0;
  AccurateCandidate best_;
};

}  // namespace

AccurateCandidate solve_to_accuracy(const Scene& scene, const Timeline& timeline, double accuracy) {
  if (scene.geometry.dim() != 2)
    throw SceneError({scene.geometry.origin.text() +
                      ": an accuracy is asked for on a mesh of your own (its cells cannot be halved from here). Refine "
                      "the mesh by hand, or describe the ground by a shape."});
  if (timeline.comparison_times.empty())
    throw SceneError(
        {scene.comparison.origin.text() +
         ": an accuracy is asked for, but no time at which fields are compared (there is nothing to measure "
         "it by). Add times to [comparison]."});
  return Search(scene, timeline, accuracy).run();
}

}  // namespace wetfront::verification
