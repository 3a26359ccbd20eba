#include "verification/suites/hydraulics/closed_form_on_points.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/seed_column.h"
#include "verification/suites/setups.h"

namespace wetfront::verification {
namespace {

/// 0.4 m of the seed paper's sand over 0.4 m of a soil a thousand times less permeable over 0.4 m of the sand, at -1 m,
/// over a draining base: water perches on the fine soil, then ponds. `cells`: a multiple of 3.
fem_reference::RichardsProblem contrast(int cells) {
  auto problem = column(1.2, cells, -1.0, {3 * hour, 8 * hour, 12 * hour});
  name_regions(problem.mesh, {"sand", "fine"}, [](const meshes::Point& at) { return at[0] > 0.4 && at[0] < 0.8; });
  problem.soils = {van_genuchten_soil({0.46 * 0.087, 0.46, 9810 / 4350., 1 / (1 - 0.61), seed_conductivity}),
                   van_genuchten_soil({0.09, 0.43, 0.8, 1.5, 1e-3 * seed_conductivity})};
  for (auto& soil : problem.soils) soil.specific_storage = soil.porosity * 9810 / 0.2e9;
  problem.boundary = {fem_reference::RainSide{"top", {{0}, {3e-6}}}, fem_reference::FreeDrainageSide{"base"}};
  return problem;
}

}  // namespace

std::vector<Case> layer_cases() {
  OnPoints test;
  test.exact.name = "layers_1e3";
  test.exact.title = "Front across layers of a thousandfold contrast";
  test.exact.requirement = "Rain passes sand, perches on a soil a thousand times less permeable and ponds.";
  test.exact.source = "Own case; the reference on 480 cells is the yardstick.";
  test.exact.problem = contrast;
  test.ladder = {30, 60, 120};
  test.gate = {1e-3, 60,
               "measured 5.5e-4 at 12 h, when the surface has ponded; second order brings it to 1.4e-4 on 120"};
  test.order = {1.8, 2.2, "interfaces lie on cell sides, so layers do not cost an order"};
  test.reference_cells = 480;
  test.time_tolerance = 1e-7;
  return {as_case(test)};
}

}  // namespace wetfront::verification
