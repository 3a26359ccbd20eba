#include "reports/write.h"
#include "verification/commands/commands.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int report(const std::filesystem::path& folder) {
  reports::render_again(folder);
  fmt::print("{}\n", (folder / "report.html").string());
  return 0;
}

}  // namespace wetfront::verification::commands
