#pragma once

#include "verification/ledger/difference_ledger.h"

#include <array>
#include <string>
#include <vector>

/// How shares are told apart; difference_ledger.cpp puts them together.
namespace wetfront::verification {

/// The quantities that a ledger explains, at one time: what integrals and fronts say is told apart more surely than
/// fields are.
enum Explains { front_position, stored_water, cumulative_flux, explained_quantities };
using Quantities = std::array<double, explained_quantities>;  ///< [m]; NaN where a solution has none

/// Reads the quantities of any solution; fronts in the cells of `cells_of`.
class QuantityReader {
 public:
  QuantityReader(const Scene& scene, std::size_t time_index, double time)
      : scene_(scene), index_(time_index), time_(time) {}
  Quantities operator()(const meshes::FieldHistory& history, const meshes::FieldHistory& cells_of) const;

 private:
  const Scene& scene_;
  std::size_t index_;
  double time_;
};

/// One cause in each of the quantities.
struct CauseShares {
  std::string cause, note;
  bool probed = true;
  Quantities value{}, uncertainty{};
  std::array<bool, explained_quantities> converged{true, true, true};
};

/// What a limit of three runs says: the first is that of the solution, the others are refined. The sum of the changes,
/// with the rest as a geometric series where they shrink; unconverged where they do not.
CauseShares limit_share(const std::string& cause, const Quantities& as_is, const Quantities& finer,
                        const Quantities& finest, const Quantities& scale);

}  // namespace wetfront::verification
