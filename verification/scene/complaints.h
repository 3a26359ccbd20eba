#pragma once

#include "verification/scene/scene.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// A line and a column of the scene file, both from 1.
struct Place {
  int line = 1, column = 1;
};

/// What is wrong, why that is a problem, what to do: rendered as `problem (why). suggestion`.
struct Complaint {
  std::string problem, why, suggestion;
  std::string text() const;
};

/// Collects what is wrong with one scene, so that a file is repaired in one go and not error by error.
class Complaints {
 public:
  explicit Complaints(std::string file) : file_(std::move(file)) {}

  void add(Place place, const Complaint& complaint);
  /// About another file (a rain record) named at `place` of the scene.
  void add_elsewhere(Place place, const std::string& file, Place there, const Complaint& complaint);

  bool any() const { return !found_.empty(); }
  /// All complaints as `file:line:column: ...`, in file order.
  std::vector<std::string> in_order() const;
  Origin origin(Place place) const { return {file_, place.line, place.column}; }

 private:
  struct Found {
    Place place;  ///< in the scene
    Place there;  ///< in the other file
    std::string message;
  };
  std::string file_;
  std::vector<Found> found_;
};

/// The known word nearest to `word` by edit distance (case does not count), or "" when none is near enough
/// to be a slip of the pen: at most a third of the letters differ.
std::string nearest(const std::string& word, const std::vector<std::string>& known);

/// At most 60 characters of it, for messages.
std::string shortened(const std::string& text);

/// "a, b or c".
std::string alternatives(const std::vector<std::string>& words);

/// `Did you mean 'x'?` when something is near, else `Use one of those.`, for messages that list what is known.
std::string suggest(const std::string& word, const std::vector<std::string>& known);

}  // namespace wetfront::verification
