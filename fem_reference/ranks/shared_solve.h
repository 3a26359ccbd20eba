#pragma once

#include "fem_reference/richards_problem.h"

#include <functional>
#include <string>

namespace wetfront::fem_reference {

/// Whether other ranks wait for this one's problems (Parallel).
bool other_ranks();
/// What keeps the ranks from sharing a problem; empty when they can.
std::string not_shareable(const RichardsProblem& problem);

/// The leader's side: sends the problem to the ranks that serve, which then run the same as `run` does here. Exceptions
/// that all ranks throw together (GaveUp, std::invalid_argument) pass; any other ends all ranks, since the rest would
/// wait for ever.
meshes::FieldHistory lead(const RichardsProblem& problem, const std::function<meshes::FieldHistory()>& run);

/// One march on all ranks at once, and one on this rank whatever the others do (solve.cpp).
meshes::FieldHistory march_together(const RichardsProblem& problem, meshes::Progress progress);
meshes::FieldHistory march_alone(const RichardsProblem& problem, meshes::Progress progress);

}  // namespace wetfront::fem_reference
