// Apart from the rest of the book, so that suites without the reference need not link it.
#include "verification/suites/case_book.h"
#include "verification/suites/problem_setup.h"

namespace wetfront::verification {

meshes::FieldHistory CaseBook::solve(const std::string& label, const fem_reference::RichardsProblem& problem) {
  describe(problem_setup(problem));
  try {
    meshes::FieldHistory history = fem_reference::solve(problem);
    enter(label, history, problem.tolerance);
    return history;
  } catch (const fem_reference::GaveUp& failure) {
    enter(label + " (gave up)", failure.partial, problem.tolerance);
    throw;
  }
}

}  // namespace wetfront::verification
