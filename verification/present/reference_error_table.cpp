#include "verification/present/reference_error_table.h"

#include "verification/compare/reference_error.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {

reports::Table reference_error_table(const std::vector<Measurement>& measurements) {
  reports::Table table;
  table.title = "The reference's own error";
  table.section = "Error of the reference";
  table.caption =
      "From meshes with cells twice and half as large (Richardson, Roache's factors of safety) and a tenth of the "
      "tolerance. Settled: the meshes differ by less than the time integration leaves open. Units as in the verdicts.";
  table.header = {"quantity", "bound", "of the mesh", "of time", "convergence", "order"};
  for (const Measurement& measurement : measurements) {
    const ReferenceError& error = measurement.reference;
    if (error.convergence == Convergence::none || std::isnan(error.bound)) continue;
    table.rows.push_back({measurement.description, fmt::format("{:.2g}", error.bound),
                          fmt::format("{:.2g}", error.spatial), fmt::format("{:.2g}", error.temporal),
                          word(error.convergence), std::isnan(error.order) ? "-" : fmt::format("{:.2f}", error.order)});
  }
  return table;
}

}  // namespace wetfront::verification
