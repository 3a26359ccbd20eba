#pragma once

#include "mpm/body_record.h"
#include "mpm/problem.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace wetfront::mpm {

/// The whole state of a run: a run cut after any step and continued from this gives the same bits as an uninterrupted
/// one.
struct State {
  double time = 0;
  std::size_t stage = 0;
  /// Carried columns, nodal fields and integrator history by name, e.g. "point.water_content", "node.pressure".
  std::map<std::string, std::vector<double>> fields;
  /// What has been recorded so far.
  meshes::FieldHistory history;
  BodyRecord body{};
};

/// Runs the stages of a problem step by step. A stage may end with an event (Stage::ends_with):
///
/// - failure: a step in which no equilibrium is found (SkeletonFailed, or any StepFailed there) is taken back and tried
///   again half as long. At FailureCriterion::shortest_step the skeleton has failed: the last equilibrium is what the
///   next stage begins with. A stage that reaches its end time without failure ends the run: the slope stands.
/// - rest: RestCriterion.
///
/// End times of later stages follow where they say how long they last (Stage::longest).
template <int dim>
class Simulation {
 public:
  explicit Simulation(const Problem<dim>& problem);  ///< throws CannotPlan
  Simulation(const Problem<dim>& problem, const State& state);
  ~Simulation();
  Simulation(Simulation&&) noexcept;

  bool finished() const;
  void step();  ///< one accepted step; throws GaveUp
  double time() const;
  double end() const;        ///< of the last stage, as far as it is known [s]
  double stage_end() const;  ///< of the present stage, if no event ends it earlier [s]
  const BodyRecord& body() const;
  State state() const;
  meshes::FieldHistory take_history();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Runs to the end of the last stage.
template <int dim>
meshes::FieldHistory run(const Problem<dim>& problem, meshes::Progress progress = nullptr);

}  // namespace wetfront::mpm
