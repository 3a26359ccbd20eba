#pragma once

#include <string>

namespace wetfront::verification {

/// Where in the scene file something was said.
struct Origin {
  std::string file;
  int line = 0, column = 0;
  std::string text() const;  ///< "file:line:column"
};

}  // namespace wetfront::verification
