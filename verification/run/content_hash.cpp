#include "verification/run/content_hash.h"

#include <fmt/format.h>

namespace wetfront::verification {

std::string ContentHash::text() const {
  return fmt::format("{:016x}", value_);
}

}  // namespace wetfront::verification
