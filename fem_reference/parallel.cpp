#include "fem_reference/parallel.h"

#include "fem_reference/linear/petsc_session.h"
#include "fem_reference/problem_message.h"
#include "fem_reference/ranks/shared_solve.h"

#include <mpi.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace wetfront::fem_reference {
namespace {

int rank_count = 1, own_rank = 0;
pid_t started_by = 0;  // processes that it forks have no part in MPI

bool under_mpirun() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

/// The leader's next word: the length of a problem to solve, or 0 for the end. Waiting costs no processor.
long hear_length() {
  long length = 0;
  MPI_Request request;
  MPI_Ibcast(&length, 1, MPI_LONG, 0, MPI_COMM_WORLD, &request);
  for (int done = 0; done == 0;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return length;
}

void say_length(long length) {
  MPI_Request request;
  MPI_Ibcast(&length, 1, MPI_LONG, 0, MPI_COMM_WORLD, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

[[noreturn]] void end_all(const char* why) {
  std::fprintf(stderr, "wetfront: rank %d of %d: %s\n", own_rank, rank_count, why);
  MPI_Abort(MPI_COMM_WORLD, 2);
  std::abort();
}

meshes::FieldHistory or_end_all(const std::function<meshes::FieldHistory()>& run) {
  try {
    return run();
  } catch (const GaveUp&) {
    throw;
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::exception& error) {
    end_all(error.what());
  } catch (...) {
    end_all("unknown error");
  }
}

}  // namespace

Parallel::Parallel() {
  if (!under_mpirun()) return;
  MPI_Init(nullptr, nullptr);
  MPI_Comm_size(MPI_COMM_WORLD, &rank_count);
  MPI_Comm_rank(MPI_COMM_WORLD, &own_rank);
  started_by = getpid();
  start_petsc();
}

Parallel::~Parallel() {
  if (!under_mpirun()) return;
  if (leads() && rank_count > 1) say_length(0);
  stop_petsc();
  MPI_Finalize();
  rank_count = 1;
}

bool Parallel::leads() const {
  return own_rank == 0;
}

int Parallel::ranks() const {
  return rank_count;
}

int Parallel::serve() const {
  while (const long length = hear_length()) {
    std::vector<char> message(length);
    MPI_Bcast(message.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
    try {
      or_end_all([&] { return march_together(unpack(message), nullptr); });
    } catch (const std::exception&) {
      // The leader has the same exception and says it.
    }
  }
  return 0;
}

bool other_ranks() {
  return rank_count > 1 && getpid() == started_by;
}

std::string not_shareable(const RichardsProblem& problem) {
  if (problem.mesh.dim == 1) return "one dimension";
  if (problem.adaptivity) return "a mesh that adapts";
  if (problem.integrator != Integrator::bdf) return "an integrator other than BDF";
  if (problem.source) return "a source given as a function";
  for (const BoundaryCondition& condition : problem.boundary) {
    if (std::holds_alternative<PeriodicSides>(condition)) return "periodic sides";
    const auto* head = std::get_if<HeadSide>(&condition);
    if (head != nullptr && head->varying) return "a head given as a function";
  }
  return "";
}

meshes::FieldHistory lead(const RichardsProblem& problem, const std::function<meshes::FieldHistory()>& run) {
  std::vector<char> message = pack(problem);
  say_length(static_cast<long>(message.size()));
  MPI_Bcast(message.data(), static_cast<int>(message.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  return or_end_all(run);
}

}  // namespace wetfront::fem_reference
