#pragma once

#include "fem_reference/integrator.h"

namespace wetfront::fem_reference {

/// Turns accepted states into a meshes::FieldHistory.
class Recorder {
 public:
  Recorder(const RichardsProblem& problem, const FlowOperator& flow, const Boundary& boundary);

  /// One ledger row and one point per gauge.
  void record_step(const State& state);
  void record_snapshot(const State& state);
  void note(std::string sentence) { history_.log.push_back(std::move(sentence)); }
  /// Completes the per-node rain, the cost and the counters; the recorder is empty afterwards.
  meshes::FieldHistory finish(const State& state, const StageKernel& kernel, const TimeIntegrator& integrator,
                              double cpu_seconds);

 private:
  /// Demand of one held dof that was met so far [m^dim].
  double evaporated(const State& state, std::size_t h) const;
  double head_at(const State& state, int cell, const double* shape) const;

  const RichardsProblem& problem_;
  const FlowOperator& flow_;
  const Boundary& boundary_;
  meshes::FieldHistory history_;
};

}  // namespace wetfront::fem_reference
