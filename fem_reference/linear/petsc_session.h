#pragma once

namespace wetfront::fem_reference {

/// PETSc for the rest of the process, started by whatever needs it first, so that a run without pays nothing. On
/// several ranks all start it at once (Parallel does). Its signal handlers and option files stay out.
void start_petsc();

/// Ends it; on several ranks before MPI ends. Without a call it ends with the process.
void stop_petsc();

}  // namespace wetfront::fem_reference
