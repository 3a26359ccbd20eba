#pragma once

#include "reports/record.h"
#include "verification/run/solve_reference.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Where a difference between candidate and reference comes from (README of this folder).
namespace wetfront::verification {

/// The candidate once more, otherwise than the scene says.
struct Rerun {
  int finer_cells = 0;             ///< halvings of every cell
  int finer_steps = 0;             ///< refinements of the time steps, each making their error several times smaller
  bool richards_only = false;      ///< without inertia of the water and motion of the skeleton
  std::vector<double> times = {};  ///< at which fields are kept [s]; empty: as the scene says
};
/// Absent: a stored result, which cannot be run again.
using CandidateRunner = std::function<Solved(const Rerun&)>;

/// One cause's part of a difference, candidate minus reference, in the unit of the quantity.
struct Share {
  std::string cause;
  double value = 0, uncertainty = 0;
  bool converged = true;  ///< the probe runs approach a limit
  bool probed = true;     ///< false: it could not be measured, `note` says why
  std::string note;
};

struct QuantityLedger {
  std::string quantity, description, unit;
  double candidate = 0, reference = 0;
  double reference_bound = 0;  ///< what the reference does not know of it
  /// Of that: what its mesh and its time steps leave open, and what cells half as large and a tenth of the tolerance
  /// really changed (finer or tighter less the reference as it is). Part of the remainder's doubt, not of the shares.
  Share reference_mesh{}, reference_steps{};
  std::vector<Share> shares;
  double remainder = 0, uncertainty = 0;  ///< uncertainty: of the remainder
  double tolerance = 0;                   ///< of the scene's gate on it, in the unit of the quantity; 0: none
  bool cancels = false;                   ///< shares of opposite sign hide each other
  reports::Verdict verdict = reports::Verdict::info;
  std::string explanation;

  double difference() const { return candidate - reference; }
  /// Sum of what there is to explain, signs apart.
  double size() const;
};

/// Of what there is to explain: with more left unexplained, most of it may be something else.
inline constexpr double small_remainder = 0.25;

/// Remainder, its uncertainty, what cancels and the verdict, from the values, the shares and the tolerance: with no
/// more than a tenth of the gate or 1e-4 of the value to explain PASS; INCONCLUSIVE where a share that matters comes
/// from runs that approach no limit; else the remainder against small_remainder of all there is.
void conclude(QuantityLedger& entry);

struct DifferenceLedger {
  double time = 0;  ///< s, at which the quantities are taken
  std::vector<QuantityLedger> quantities;
  /// Causes, the gravest first: by their mean share of what there is to explain, over the quantities where there is
  /// anything. "remainder" is one of them.
  std::vector<std::pair<std::string, double>> causes;
  double cpu_seconds = 0;  ///< of the probe runs
  std::vector<std::string> log;
};

/// What the ledger explains: two solutions of a scene and how the candidate can be run again.
struct Explained {
  const Scene& scene;
  const Timeline& timeline;
  const meshes::FieldHistory& candidate;
  const ReferenceRuns& reference;
  CandidateRunner rerun;
  ReferenceStore store;
};
DifferenceLedger difference_ledger(const Explained& explained);

/// Findings (one per quantity), a table of shares each, and the sentence at the top, for a page.
void add_ledger(reports::Record& record, const DifferenceLedger& ledger);

}  // namespace wetfront::verification
