#pragma once

#include "fem_reference/time/integrator.h"

namespace wetfront::fem_reference {

/// All that hangs on the degrees of freedom of the moment, in the order in which the parts need each other; made anew
/// when the mesh changes.
struct System {
  System(const RichardsProblem& problem, Discretisation discretisation);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  Discretisation space;
  Boundary boundary;
  FlowOperator flow;
  StageKernel kernel;
  std::unique_ptr<TimeIntegrator> integrator;
};

/// What the systems of a run cost together.
class Effort {
 public:
  /// Before a system goes.
  void add(const System& system);
  void step_taken(const System& system);
  /// Fills the counters, the cost and the solver's name.
  void report(const RichardsProblem& problem, const System& last, double cpu_seconds, meshes::FieldHistory& history);

 private:
  std::map<std::string, double> counters_;
  Cost evaluation_, assembly_, linear_;
  double dof_steps_ = 0, steps_ = 0;
  int most_dofs_ = 0;
};

}  // namespace wetfront::fem_reference
