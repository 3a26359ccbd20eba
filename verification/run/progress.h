#pragma once

#include <string>

namespace wetfront::verification {

/// A line on stderr that shows physical time, share done and the time left, rewritten in place.
/// Silent when stderr is not a terminal. One at a time; the line is wiped when it goes out of scope.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
};

/// The function solvers call (meshes::Progress): physical time reached, end time [s], what is being done.
void show_progress(double time, double end, const char* what);

}  // namespace wetfront::verification
