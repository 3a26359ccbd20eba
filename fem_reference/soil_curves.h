#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::fem_reference {

/// A function of pressure head and its derivative with respect to it.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// Effective saturation Se(psi) [-] and dSe/dpsi [1/m] of the printed laws for psi < 0 (van Genuchten's without its
/// cut-off, HaverkampLog's for psi < -entry). Formulas and sources: richards_problem.h.
ValueAndSlope effective_saturation(const VanGenuchten& law, double head);
ValueAndSlope effective_saturation(const ExponentialRetention& law, double head);
ValueAndSlope effective_saturation(const HaverkampRetention& law, double head);
ValueAndSlope effective_saturation(const HaverkampLogRetention& law, double head);
ValueAndSlope effective_saturation(const BroadbridgeWhiteRetention& law, double head);

/// K/Ks [-] and its derivative [1/m] for psi < 0.
ValueAndSlope mualem(const VanGenuchten& law, double head);
ValueAndSlope relative_conductivity(const HaverkampConductivity& law, double head);
ValueAndSlope broadbridge_white(const BroadbridgeWhiteRetention& law, double head);

}  // namespace wetfront::fem_reference
