#pragma once

#include "mpm/problem.h"
#include "verification/run/checkpoint.h"
#include "verification/run/solve_reference.h"

namespace wetfront::verification {

/// How a run can be stopped and gone on with.
struct Stopping {
  CheckpointFile checkpoint{};  ///< no file: none is kept
  double every = 60;            ///< s of wall time between checkpoints
  bool resume = false;          ///< go on from the checkpoint, where there is one; one that cannot be used is refused
};

/// Runs the candidate to its end, until it gives up or until Ctrl-C (SIGINT, SIGTERM), which leaves a checkpoint and
/// what has been computed. The checkpoint stays when the run reaches its end: whoever keeps the results forgets it.
/// Throws std::invalid_argument when what it is to go on from is broken or of another scene or program.
Solved run_candidate(const mpm::Problem<2>& problem, const Stopping& stopping = {});

}  // namespace wetfront::verification
