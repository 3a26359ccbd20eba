#include "verification/exact/srivastava_yeh_two_layer.h"
#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace wetfront::verification {

ClosedFormCase two_layer_case(double lower, double upper, double rain) {
  const exact::SrivastavaYehTwoLayer soil{10.0,
                                          {lower * cm_per_hour, 0.06, 0.40, 1.0},
                                          {upper * cm_per_hour, 0.06, 0.40, 1.0},
                                          0.1 * cm_per_hour,
                                          rain * cm_per_hour};
  const auto solution = std::make_shared<exact::SrivastavaYehTwoLayerSolution>(soil);
  const auto over_interface = [](double elevation) { return std::clamp(elevation - 1.0, -1.0, 1.0); };
  ClosedFormCase test;
  test.name = fmt::format("two_layers_{:g}_{:g}", lower, upper);
  std::replace(test.name.begin(), test.name.end(), '.', 'p');
  test.title = fmt::format("R3 Srivastava-Yeh, two layers, Ks {:g} below and {:g} cm/h above", lower, upper);
  test.requirement = "Rain passes the interface of two soils with continuous head and flux.";
  test.source = "Srivastava & Yeh 1991, section 3, in self-adjoint form.";
  test.problem = [=](int cells) {
    const std::vector<double> times = {hour, 2 * hour, 5 * hour, 10 * hour, 20 * hour, 50 * hour, 100 * hour};
    fem_reference::RichardsProblem problem = column(2.0, cells, 0, times);
    name_regions(problem.mesh, {"lower", "upper"}, [](const meshes::Point& at) { return at[0] > 1 ? 1 : 0; });
    for (const auto& layer : {soil.lower, soil.upper})
      problem.soils.push_back(gardner_soil(layer.theta_r, layer.theta_s, soil.alpha, layer.conductivity));
    problem.boundary = {fem_reference::RainSide{"top", {{0}, {soil.flux_after}}}, fem_reference::HeadSide{"base", 0}};
    start_from(problem, [&](const meshes::Point& at) { return solution->head(over_interface(at[0]), 0); });
    problem.tolerance = 1e-7;
    return problem;
  };
  test.head = [=](const meshes::Point& at, double t) { return solution->head(over_interface(at[0]), t); };
  test.ladder = {100, 200, 400};
  test.gate = {1e-3, 200, "gate R3: 1e-3 relative at 200 cells"};
  test.order = {1.9, 2.1, "gate R3 asks for at least 1.9; more than 2.1 would be no second-order scheme either"};
  return test;
}

std::vector<Case> two_layer_cases() {
  return {as_case(two_layer_case(10, 1, 0.9)), as_case(two_layer_case(1, 10, 0.9)),
          as_case(two_layer_case(0.9, 900, 0.8))};
}

}  // namespace wetfront::verification
