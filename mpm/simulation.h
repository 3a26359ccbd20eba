#pragma once

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
};

/// Runs the stages of a problem step by step.
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
