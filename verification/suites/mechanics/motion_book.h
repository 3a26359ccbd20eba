#pragma once

#include "verification/suites/case_book.h"
#include "verification/suites/mechanics/energy_split.h"
#include "verification/suites/mechanics/motion.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The book of a case whose skeleton moves: runs problems, keeps the table of runs (points, steps, crossings, CPU) and
/// judges what every such run owes, whatever the case is about: momentum balanced to round-off, energy as the scheme
/// promises.
class MotionBook {
 public:
  explicit MotionBook(CaseBook& page);

  /// Runs and enters the run. Throws mpm::CannotPlan and mpm::GaveUp.
  template <int dim>
  Motion<dim> move(const std::string& label, const mpm::Problem<dim>& problem,
                   const std::function<bool(const Cloud<dim>&)>& enough = nullptr);
  void finish();  ///< the table, and the balances as findings
  CaseBook& page;
  /// What mapping between points and nodes may lose of the energy of the runs to come, over what was exchanged.
  Gate energy = round_off_energy;
  /// What it may make of it. Absent: no more than it may lose, and no more than made_by_weight where weight or contact
  /// act, made_without elsewhere.
  std::optional<Gate> energy_made;
  static const Gate round_off_energy;  ///< of FLIP without PIC, weight, contact and damping
  static const Gate made_by_weight, made_without;

 private:
  void enter(const std::string& label, const meshes::FieldHistory& history, std::size_t points, int threads);
  void balance(const meshes::FieldHistory& history);
  void enter_energy(const std::string& label, const EnergySplit& split, const Gate& made);
  reports::Table runs_, energies_;
  double momentum_ = 0;  ///< worst drift of momentum of the runs, relative to what was exchanged
  /// Worst of energy by mapping under one pair of gates, relative to what was exchanged.
  struct Mapping {
    Gate may_lose, may_make;
    double lost = 0, made = 0;
    int runs = 0;
  };
  std::vector<Mapping> mappings_;
  int balanced_ = 0;  ///< runs with a ledger
};

/// A case whose page is written through a MotionBook.
Case motion_case(Case heading, std::function<void(MotionBook&)> run);

}  // namespace wetfront::verification
