#pragma once

#include <string>

namespace wetfront::verification {

/// A line on stderr that shows physical time, share done and the time left of the present stage, rewritten in place;
/// where stderr is not a terminal, a new line every half a minute. One at a time; the line is wiped when it goes out of
/// scope.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
};

/// The function solvers call (meshes::Progress): physical time reached, when the present stage ends at the latest [s],
/// and its name.
void show_progress(double time, double end, const char* what);

/// How fast a stage goes, since it began or was gone on with: what came before it went at another pace.
class Pace {
 public:
  /// Wall time [s] until the stage's end, at physical time `time` [s] and `wall` seconds after the run began; negative
  /// where nothing is known yet.
  double left(const std::string& stage, double time, double end, double wall);

 private:
  std::string stage_;
  double from_time_ = 0, from_wall_ = -1;
};

}  // namespace wetfront::verification
