#pragma once

namespace wetfront::fem_reference {

/// MPI for the life of the object where the program was started by mpirun (its environment says so), else nothing at
/// all. Rank 0 leads: it runs the program, prints and writes; the others serve its solves. So a program starts with
///   const Parallel parallel;
///   if (!parallel.leads()) return parallel.serve();
/// A problem is solved on all ranks when it has two or three dimensions, integrator bdf, a mesh that stays, no periodic
/// sides and no functions of place (which cannot be sent); else on rank 0 alone, and the record's log says so.
class Parallel {
 public:
  Parallel();
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  bool leads() const;
  int ranks() const;
  /// Takes part in the leader's solves until the leader ends; returns 0, the exit code of a rank that served well.
  int serve() const;
};

}  // namespace wetfront::fem_reference
