#include "verification/present/flux_tables.h"

#include "verification/present/side_table.h"
#include "verification/present/tables.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {

std::vector<reports::Table> compared_fluxes(const Scene& scene, const Timeline& window, double failure,
                                            const meshes::FieldHistory& candidate,
                                            const meshes::FieldHistory& reference) {
  std::vector<reports::Table> tables = {
      ledger_table("reference", reference, ledger_area(scene, reference.mesh), window)};
  if (!candidate.sides.empty()) {
    tables.push_back(side_table("MPM", candidate, window));
    tables.push_back(side_table("reference", reference, window));
  }
  if (!std::isfinite(failure)) return tables;
  for (reports::Table& table : tables) {
    table.title += " until failure";
    table.caption += fmt::format(" It ends with the failure at {:.6g} s: the reference knows no motion.", failure);
  }
  return tables;
}

reports::Table ledger_of_run(const Scene& scene, const Timeline& timeline, double failure,
                             const meshes::FieldHistory& candidate) {
  Timeline rows = timeline;
  if (std::isfinite(failure)) rows.comparison_times.push_back(failure);
  return ledger_table("MPM", candidate, ledger_area(scene, candidate.mesh), rows);
}

}  // namespace wetfront::verification
