#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/ledger/observed_soil.h"
#include "verification/ledger/shares.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The factors of safety of compare/reference_error: 1.25 for an observed order, 2 in time.
inline constexpr double mesh_safety = 1.25, step_safety = 2;

Quantities operator-(const Quantities& a, const Quantities& b);

/// Runs the probes of a ledger; each leaves one cause's shares.
class Probes {
 public:
  /// `index` tells the comparison time at which the quantities are taken.
  Probes(const Explained& it, std::size_t index);

  std::vector<CauseShares> all();

  /// One side's doubt of the reference: what the refinement changed, and that times its factor of safety.
  static Share of_the_reference(const std::string& cause, const Quantities& change, double safety, int quantity);

  Quantities candidate;  ///< of the candidate, in its cells
  Quantities truth;      ///< of the reference, in its own
  Quantities on_cells;   ///< of the reference, in the candidate's cells
  Quantities bound;      ///< what the reference does not know: the sum of the two below, with their factors
  Quantities by_finer_cells, by_tighter_steps;  ///< what these change of the reference
  double cpu_seconds = 0;
  std::vector<std::string> log;

 private:
  using Change = std::function<void(fem_reference::RichardsProblem&)>;
  /// Absent where the run gave up or could not be begun: a probe must not lose the run that it explains.
  std::optional<meshes::FieldHistory> reference_with(const std::string& what, const Change& change);
  std::optional<meshes::FieldHistory> again(const std::string& what, const Rerun& rerun);
  std::optional<meshes::FieldHistory> finished(const std::string& what, const std::function<Solved()>& run);

  CauseShares boundary();
  CauseShares interpolation();
  CauseShares limit(const std::string& cause, const std::string& what, int Rerun::*part, double cost_factor);
  CauseShares physics();
  std::vector<CauseShares> laws();  // probe_laws.cpp, as is what follows
  CauseShares law_share(const std::string& cause, const std::string& note, const ObservedSoil* content,
                        const ObservedSoil* conductivity);
  std::optional<Quantities> with_tables(const std::string& what, const ObservedSoil* content,
                                        const ObservedSoil* conductivity);
  bool beyond_richards() const;
  double water_passed_through() const;

  const Explained& it_;
  std::size_t index_;
  QuantityReader read_;
  const fem_reference::RichardsProblem problem_;  ///< the reference's, as the scene says
  std::optional<Quantities> in_tables_;           ///< of the reference with its own laws in tables
};

/// Shares that were not measured, and why.
CauseShares unprobed(const std::string& cause, const std::string& why);

}  // namespace wetfront::verification
