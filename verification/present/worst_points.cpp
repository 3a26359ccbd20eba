#include "verification/present/worst_points.h"

#include "verification/compare/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::verification {
namespace {

constexpr std::size_t listed = 10, written = 1000;

/// A field in the cells, of both solutions at one time.
struct Compared {
  std::string name, file_name, unit;  ///< "pore pressure", "pore_pressure [Pa]", "kPa"
  double per_unit;                    ///< of `unit` [Pa, 1]
  const std::vector<double>*candidate, *reference;
};

/// Cells by their share of the squared error, the largest first; those without a weight or a share are none.
struct Ranked {
  std::vector<std::size_t> cells;
  std::vector<double> share;  ///< of the whole squared error, per cell of the mesh
};

Ranked ranked(const Compared& field, const std::vector<double>& weight) {
  Ranked out;
  double whole = 0;
  for (std::size_t c = 0; c < weight.size(); ++c) {
    out.share.push_back(weight[c] * std::pow((*field.candidate)[c] - (*field.reference)[c], 2));
    whole += out.share.back();
  }
  for (std::size_t c = 0; c < weight.size(); ++c)
    if (out.share[c] > 0) out.share[c] /= whole, out.cells.push_back(c);
  std::ranges::stable_sort(out.cells, [&](std::size_t a, std::size_t b) { return out.share[a] > out.share[b]; });
  if (out.cells.size() > written) out.cells.resize(written);
  return out;
}

reports::Table table_of(const Compared& field, const Ranked& worst, const meshes::Mesh& mesh, double time) {
  const int dim = mesh.dim;
  reports::Table table{
      fmt::format("Worst points: {} at {:.6g} s", field.name, time),
      "Worst points",
      fmt::format("The {} centres of cells that make most of the error; fields/worst_points.pvd has {}.",
                  std::min(listed, worst.cells.size()), worst.cells.size()),
      {},
      {}};
  for (int axis = 0; axis < dim; ++axis) table.header.push_back(std::string(1, "xyz"[axis]) + " [m]");
  for (const char* title : {"candidate", "reference", "difference"})
    table.header.push_back(fmt::format("{} [{}]", title, field.unit));
  table.header.push_back("of the squared error [%]");
  for (std::size_t rank = 0; rank < std::min(listed, worst.cells.size()); ++rank) {
    const std::size_t c = worst.cells[rank];
    const meshes::Point place = mesh.cell_centre(c);
    const double ours = (*field.candidate)[c] / field.per_unit, theirs = (*field.reference)[c] / field.per_unit;
    std::vector<std::string> row;
    for (int axis = 0; axis < dim; ++axis) row.push_back(fmt::format("{:.4g}", place[static_cast<std::size_t>(axis)]));
    for (const double value : {ours, theirs, ours - theirs}) row.push_back(fmt::format("{:.4g}", value));
    row.push_back(fmt::format("{:.1f}", 100 * worst.share[c]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

reports::FieldFile file_of(const Compared& field, const Ranked& worst, const meshes::Mesh& mesh, double time) {
  reports::FieldFile file;
  file.stem = "worst_points";
  file.time = time;
  file.dim = mesh.dim;
  const auto [quantity, unit] = std::pair{field.file_name.substr(0, field.file_name.find(' ')),
                                          field.file_name.substr(field.file_name.find(' '))};
  std::vector<double> ours, theirs, difference, share;
  for (const std::size_t c : worst.cells) {
    const meshes::Point place = mesh.cell_centre(c);
    file.nodes.insert(file.nodes.end(), place.begin(), place.end());
    ours.push_back((*field.candidate)[c]);
    theirs.push_back((*field.reference)[c]);
    difference.push_back(ours.back() - theirs.back());
    share.push_back(worst.share[c]);
  }
  file.fields = {{quantity + "_candidate" + unit, false, 1, std::move(ours)},
                 {quantity + "_reference" + unit, false, 1, std::move(theirs)},
                 {quantity + "_difference" + unit, false, 1, std::move(difference)},
                 {"share_of_squared_error [-]", false, 1, std::move(share)}};
  return file;
}

}  // namespace

WorstPoints worst_points(const std::vector<reports::Finding>& findings, const std::vector<Measurement>& measurements,
                         const Histories& histories) {
  const auto failed = [&](std::size_t time, const std::string& field) {
    return std::ranges::any_of(measurements, [&](const Measurement& one) {
      return one.time_index == static_cast<int>(time) && one.quantity.starts_with(field) &&
             std::ranges::any_of(findings, [&](const reports::Finding& finding) {
               return finding.quantity == one.quantity && finding.description == one.description &&
                      finding.verdict == reports::Verdict::fail;
             });
    });
  };
  WorstPoints out;
  const std::size_t times = std::min(histories.candidate.snapshots.size(), histories.reference.snapshots.size());
  std::vector<Profile> candidate, reference;
  for (std::size_t t = 0; t < times; ++t)
    for (const bool pressure : {true, false}) {
      if (!failed(t, pressure ? "pressure_" : "saturation_")) continue;
      if (candidate.empty()) {
        candidate = cell_profiles(histories.candidate);
        reference = profiles_at_cells(histories.reference, histories.candidate);
      }
      const Compared field =
          pressure
              ? Compared{"pore pressure",        "pore_pressure [Pa]",  "kPa", 1000,
                         &candidate[t].pressure, &reference[t].pressure}
              : Compared{"saturation", "saturation [-]", "-", 1, &candidate[t].saturation, &reference[t].saturation};
      const meshes::Mesh& mesh = histories.candidate.mesh;
      const Ranked worst = ranked(field, cell_weights(mesh, histories.reference.mesh));
      out.tables.push_back(table_of(field, worst, mesh, candidate[t].time));
      out.files.push_back(file_of(field, worst, mesh, candidate[t].time));
    }
  return out;
}

}  // namespace wetfront::verification
