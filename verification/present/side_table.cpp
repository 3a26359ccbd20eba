#include "verification/present/side_table.h"

#include "verification/present/tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

/// A cumulative column of the ledger at a time, linear between its rows.
double at(const meshes::FieldHistory& history, const std::vector<double>& column, double time) {
  if (column.size() != history.ledger.size() || column.empty()) return 0;
  const auto& rows = history.ledger;
  const auto after = std::ranges::lower_bound(rows, time, {}, &meshes::LedgerRow::time) - rows.begin();
  if (after == 0) return column.front();
  if (after == static_cast<std::ptrdiff_t>(rows.size())) return column.back();
  const double share = (time - rows[after - 1].time) / (rows[after].time - rows[after - 1].time);
  return column[after - 1] + share * (column[after] - column[after - 1]);
}

std::string litres(double volume) {
  return fmt::format("{:.4f}", 1000 * volume);
}

}  // namespace

reports::Table side_table(const std::string& who, const meshes::FieldHistory& history, const Timeline& timeline) {
  const std::string unit = history.mesh.dim == 1 ? "l/m2" : history.mesh.dim == 2 ? "l/m" : "l";
  reports::Table table;
  table.title = "Water through each side of the " + who;
  table.section = "Flux audit";
  table.caption =
      "Since the start. Asked is rain or inflow, outflow is what leaves other than as vapour: negative, water "
      "came in other than as rain.";
  table.header = {"side", "condition", "time [s]"};
  for (const char* column : {"asked", "run off", "outflow", "evaporation demanded", "evaporated"})
    table.header.push_back(std::string(column) + " [" + unit + "]");
  if (history.ledger.empty()) return table;
  const std::vector<double> times = audit_times(history, timeline);
  for (const meshes::SideLedger& side : history.sides)
    for (const double time : times)
      table.rows.push_back({side.side, side.condition, fmt::format("{:.6g}", time),
                            litres(at(history, side.asked, time)), litres(at(history, side.run_off, time)),
                            litres(at(history, side.outflow, time)), litres(at(history, side.demanded, time)),
                            litres(at(history, side.evaporated, time))});
  return table;
}

}  // namespace wetfront::verification
