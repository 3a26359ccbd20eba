#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/hydraulics/closed_form_on_points.h"
#include "verification/suites/hydraulics/families.h"

namespace wetfront::verification {
namespace {

const OrderGate second_order{1.8, 2.2, "linear cells with lumped storage are of second order; the issue asks for 1.8"};

Case one_layer(double alpha, bool wetting, ClosedFormCase::Judged gate) {
  return as_case(OnPoints{srivastava_yeh_case(alpha, wetting, gate), {50, 100, 200}, gate, second_order});
}

Case two_layers(double lower, double upper, double rain) {
  const ClosedFormCase::Judged gate{1e-3, 200, "gate R3 of the reference, met by the points too"};
  return as_case(OnPoints{two_layer_case(lower, upper, rain), {50, 100, 200}, gate, second_order});
}

}  // namespace

std::vector<Case> closed_form_water_cases() {
  const ClosedFormCase::Judged r2{3.5e-4, 100, "gate R2 of the reference, met by the points too"};
  const ClosedFormCase::Judged surface_dries{
      3.5e-4, 200, "gate R2 on 200 cells: cells of 1 cm do not resolve the surface as it dries in the first hours"};
  return {one_layer(10, true, r2), one_layer(1, true, r2), one_layer(10, false, surface_dries),
          one_layer(1, false, r2), two_layers(10, 1, 0.9), two_layers(1, 10, 0.9)};
}

}  // namespace wetfront::verification
