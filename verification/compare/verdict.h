#pragma once

#include "reports/record.h"
#include "verification/compare/measure.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// The rule of every gate: with error E, the reference's own uncertainty u and tolerance T,
/// PASS if E + u <= T, FAIL if E - u > T, else INCONCLUSIVE: also when E or u is not a number, and when u > T, for a
/// reference that uncertain cannot condemn (the difference of two runs understates a slowly converging error).
reports::Verdict verdict(double error, double reference_bound, double tolerance);

/// "PASS", "FAIL", "INCONCLUSIVE", or "no gate".
const char* word(reports::Verdict verdict);

/// Judges measurements by the scene's tolerances. A measurement without a tolerance is shown, not gated; a tolerance
/// that no measurement answers is INCONCLUSIVE and says so.
std::vector<reports::Finding> judge(const Scene& scene, const Timeline& timeline,
                                    const std::vector<Measurement>& measurements, double cpu_seconds);

/// The worst of the findings: FAIL before INCONCLUSIVE before PASS; INFO where nothing is gated.
reports::Verdict overall(const std::vector<reports::Finding>& findings);

}  // namespace wetfront::verification
