#include "verification/run/problem_hash.h"

#include "fem_reference/problem_message.h"
#include "verification/run/content_hash.h"
#include "verification/run/version.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

bool holds_functions(const fem_reference::RichardsProblem& problem) {
  return problem.source || std::ranges::any_of(problem.boundary, [](const auto& condition) {
           const auto* head = std::get_if<fem_reference::HeadSide>(&condition);
           return head != nullptr && head->varying;
         });
}

}  // namespace

std::optional<std::string> problem_hash(const fem_reference::RichardsProblem& problem) {
  if (holds_functions(problem)) return {};
  ContentHash hash;
  hash.add(fem_reference::pack(problem));
  hash.add(std::string_view(version::reference_code));
  return hash.text();
}

}  // namespace wetfront::verification
