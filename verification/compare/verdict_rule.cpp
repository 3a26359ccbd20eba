// The rule of every gate, without the scenes that other judgements need.
#include "verification/compare/verdict.h"

#include <cmath>

namespace wetfront::verification {

using reports::Finding;
using reports::Verdict;

Verdict verdict(double error, double reference_bound, double tolerance) {
  if (std::isnan(error) || !(reference_bound <= tolerance)) return Verdict::inconclusive;
  if (error + reference_bound <= tolerance) return Verdict::pass;
  if (error - reference_bound > tolerance) return Verdict::fail;
  return Verdict::inconclusive;
}

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "PASS";
    case Verdict::fail:
      return "FAIL";
    case Verdict::inconclusive:
      return "INCONCLUSIVE";
    case Verdict::info:
      return "no gate";
  }
  return "";
}

Verdict overall(const std::vector<Finding>& findings) {
  Verdict worst = Verdict::info;
  for (const Finding& finding : findings) {
    if (finding.verdict == Verdict::fail) return Verdict::fail;
    if (finding.verdict == Verdict::inconclusive) worst = Verdict::inconclusive;
    if (finding.verdict == Verdict::pass && worst == Verdict::info) worst = Verdict::pass;
  }
  return worst;
}

}  // namespace wetfront::verification
