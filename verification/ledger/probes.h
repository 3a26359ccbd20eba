#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/ledger/shares.h"
#include "verification/translate/to_reference.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

Quantities operator-(const Quantities& a, const Quantities& b);

/// Runs the probes of a ledger; each leaves one cause's shares.
class Probes {
 public:
  /// `index` tells the comparison time at which the quantities are taken.
  Probes(const Explained& it, std::size_t index);

  std::vector<CauseShares> all();

  Quantities candidate;  ///< of the candidate, in its cells
  Quantities truth;      ///< of the reference, in its own
  Quantities on_cells;   ///< of the reference, in the candidate's cells
  Quantities bound;      ///< what the reference does not know
  double cpu_seconds = 0;
  std::vector<std::string> log;

 private:
  using Change = std::function<void(fem_reference::RichardsProblem&)>;
  meshes::FieldHistory reference_with(const std::string& what, const Change& change);
  std::optional<meshes::FieldHistory> again(const std::string& what, const Rerun& rerun);
  void note(const std::string& what, const meshes::FieldHistory& history);

  CauseShares boundary();
  CauseShares interpolation();
  CauseShares limit(const std::string& cause, const std::string& what, int Rerun::*part, double cost_factor);
  CauseShares physics();
  std::vector<CauseShares> laws();  // probe_laws.cpp
  bool beyond_richards() const;
  double water_passed_through() const;

  const Explained& it_;
  std::size_t index_;
  QuantityReader read_;
  Resolution resolution_{};
};

/// Shares that were not measured, and why.
CauseShares unprobed(const std::string& cause, const std::string& why);

}  // namespace wetfront::verification
