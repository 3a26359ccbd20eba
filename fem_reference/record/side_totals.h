#pragma once

#include "fem_reference/time/integrator.h"

namespace wetfront::fem_reference {

/// The water that passed each side since the start, whatever the degrees of freedom were meanwhile: sums up what the
/// integrator's totals (State::totals, one per held dof) grow by from step to step. A dof that several sides feed is
/// split by what each offers or demands (HeldDof::Catchment); what seeps out of it goes to the side it is held for.
class SideTotals {
 public:
  explicit SideTotals(const RichardsProblem& problem);

  /// Reads the totals of these dofs from here on.
  void attach(const Boundary& boundary, const Ranks& ranks, const State& state);
  /// Adds what passed since the last call or attach(); in between the records must have been linear.
  void advance(const State& state);
  /// Water that a change of the mesh could not place in the soil again [m^dim].
  void lose(double water) { sums_.back().outflow += water; }

  // What follows sums up over all ranks, which call it at once.

  /// The columns of a row of the ledger, but the time and what is stored.
  meshes::LedgerRow row() const;
  /// Appends a value to each column.
  void append_to(std::vector<meshes::SideLedger>& sides) const;

 private:
  struct Sums {
    double asked = 0, run_off = 0, outflow = 0, evaporated = 0, demanded = 0;
  };
  std::vector<Sums> of_all_ranks() const;
  void advance_dof(const HeldDof& held, double span, double run_off, double unmet);

  /// A line of the record: conditions that pass water, the source, the adapting of the mesh.
  struct Entry {
    std::size_t index;
    std::string side, condition;
  };

  const RichardsProblem& problem_;
  std::vector<Entry> shown_;
  const Boundary* boundary_ = nullptr;
  Ranks ranks_;
  double time_ = 0;
  std::vector<double> last_;  ///< State::totals at the last call
  std::vector<Sums> sums_;    ///< per condition, then the source, then what adapting the mesh lost
};

}  // namespace wetfront::fem_reference
