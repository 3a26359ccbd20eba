#pragma once

#include "verification/suites/closed_form_case.h"

/// Closed forms that judge the reference and, on the same problems, the material point method.
namespace wetfront::verification {

/// One layer of 1 m, alpha [1/m], flux from 0.1 to 0.9 cm/h (wetting) or back.
ClosedFormCase srivastava_yeh_case(double alpha, bool wetting, ClosedFormCase::Judged gate);

/// Two layers of 1 m, Ks in cm/h; the rain jumps from 0.1 to `rain` cm/h.
ClosedFormCase two_layer_case(double lower, double upper, double rain);

/// Rain on a layer of 1 m on an infinite slope, `degrees` steep, periodic sides.
ClosedFormCase sloping_layer_case(double degrees);

}  // namespace wetfront::verification
