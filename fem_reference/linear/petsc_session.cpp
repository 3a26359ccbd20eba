#include "fem_reference/linear/petsc_session.h"

#include <petscsys.h>

#include <stdexcept>

namespace wetfront::fem_reference {
namespace {

struct Session {
  bool runs = false;
  ~Session() { stop(); }
  void start() {
    if (runs) return;
    for (const char* option : {"-no_signal_handler", "-skip_petscrc"}) PetscOptionsSetValue(nullptr, option, nullptr);
    if (PetscInitializeNoArguments() != 0) throw std::runtime_error("PETSc did not start");
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    runs = true;
  }
  void stop() {
    if (runs) PetscFinalize();
    runs = false;
  }
};

Session& session() {
  static Session only;
  return only;
}

}  // namespace

void start_petsc() {
  session().start();
}

void stop_petsc() {
  session().stop();
}

}  // namespace wetfront::fem_reference
