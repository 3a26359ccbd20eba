// Fronts across contrasts of conductivity; cells of very different heights.
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/setups.h"

#include <cmath>

namespace wetfront::verification {
namespace {

constexpr const char* by_reference = "our FEM on cells four times smaller";

const HardSoil coarse{.ks = 1e-3, .porosity = 0.4, .air_entry = 1000, .n = 3, .s_min = 0.1};
const HardSoil fine{.ks = 1e-6, .porosity = 0.45, .air_entry = 8000, .n = 1.6, .s_min = 0.15};

HardColumn layered(bool fine_above) {
  HardColumn column;
  column.height = 1;
  column.soils = {coarse, fine};
  column.soil_at = [fine_above](double z) { return (z > 0.5) == fine_above ? 1 : 0; };
  column.pressure = [](double) { return -20e3; };
  column.rain = {{0}, {fine_above ? 8e-7 : 2e-6}};
  column.outputs = {60, 1 * day, 2 * day};
  return column;
}

HardColumn many_layers() {
  HardColumn column = layered(true);
  column.soil_at = [](double z) { return static_cast<std::size_t>(std::floor(z / 0.05)) % 2; };  // two cells each
  column.rain = {{0}, {5e-7}};
  return column;
}

HardColumn graded() {
  HardColumn column;
  column.pressure = [](double) { return -50e3; };
  column.rain = {{0}, {1e-4}};
  column.outputs = {10, 600, 1200};
  // From 100 mm at the base to 1 mm at the surface, geometrically.
  const int cells = 40;
  std::vector<double> heights;
  double sum = 0;
  for (int k = 0; k < cells; ++k) sum += heights.emplace_back(std::pow(0.01, k / (cells - 1.0)));
  column.elevations = {0};
  for (double h : heights) column.elevations.push_back(column.elevations.back() + h * column.height / sum);
  column.elevations.back() = column.height;
  return column;
}

}  // namespace

std::vector<HardCase> layer_rows() {
  const char* reason = "the arrival at an interface is known to a cell, and both sides answer differently";
  return {column_case({.name = "layers_fine_over_coarse",
                       .title = "Fine over coarse, contrast 1e3",
                       .requirement = "A capillary barrier: water stands above the coarse layer, then breaks through.",
                       .source = by_reference,
                       .column = layered(true),
                       .ends = {2 * day, 60},
                       .seepage_until = 1 * day,
                       .cells_off = 1,
                       .reason = reason}),
          column_case({.name = "layers_coarse_over_fine",
                       .title = "Coarse over fine, contrast 1e3",
                       .requirement = "Water perches on the fine layer.",
                       .source = by_reference,
                       .column = layered(false),
                       .ends = {2 * day, 60},
                       .seepage_until = 1 * day,
                       .cells_off = 1,
                       .reason = reason}),
          column_case({.name = "many_thin_layers",
                       .title = "Twenty layers of two cells, contrast 1e3",
                       .requirement = "A front crosses twenty interfaces.",
                       .source = by_reference,
                       .column = many_layers(),
                       .ends = {2 * day, 60},
                       .seepage_until = 1 * day,
                       .cells_off = 1,
                       .reason = reason}),
          column_case({.name = "graded_cells",
                       .title = "Cells from 1 mm to 100 mm",
                       .requirement = "The smallest cell must not rule the implicit schemes.",
                       .source = by_reference,
                       .column = graded(),
                       .ends = {1200, 10},
                       .seepage_until = 600,
                       .cells_off = 1,
                       .reason = "in mean cells of 30 mm; where the front ends, cells are about as large"})};
}

}  // namespace wetfront::verification
