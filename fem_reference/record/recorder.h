#pragma once

#include "fem_reference/record/record_mesh.h"
#include "fem_reference/record/side_totals.h"

#include <optional>

namespace wetfront::fem_reference {

/// Turns accepted states into a meshes::FieldHistory on one mesh, whatever the degrees of freedom of the moment are.
class Recorder {
 public:
  explicit Recorder(const RichardsProblem& problem);

  /// Reads these degrees of freedom from here on. After detach(), or first of all.
  void attach(const FlowOperator& flow, const Boundary& boundary, const State& state);
  /// Takes down what the degrees of freedom of now have counted; then they may go.
  void detach(const State& state);
  /// One ledger row and one point per gauge.
  void record_step(const State& state);
  void record_snapshot(const State& state);
  void note(std::string sentence) { history_.log.push_back(std::move(sentence)); }
  /// Water that a change of the mesh could not place in the soil again [m^dim]; the ledger has it from the next row on.
  void lose(double water) { totals_.lose(water); }
  /// Completes the per-node rain and the counters of the sides; the recorder is empty afterwards.
  meshes::FieldHistory finish(const State& state);

 private:
  void record_gauges(const State& state);
  void count_sides();
  void collect_rain(const State& state);
  void collect_rain_by_dof(const State& state);
  void collect_rain_of_all();

  const RichardsProblem& problem_;
  const FlowOperator* flow_ = nullptr;
  const Boundary* boundary_ = nullptr;
  std::optional<RecordMesh> mesh_;
  SideTotals totals_;
  std::vector<double> catchment_;                  ///< per node of the record's mesh [m^(dim-1)]
  std::vector<double> rain_asked_, rain_run_off_;  ///< per node of the record's mesh [m^dim]; with adaptivity only
  meshes::FieldHistory history_;
};

}  // namespace wetfront::fem_reference
