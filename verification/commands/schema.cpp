#include "verification/commands/commands.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int schema(bool as_page) {
  fmt::print("{}", as_page ? scene_reference_page() : scene_schema());
  return 0;
}

}  // namespace wetfront::verification::commands
