#include "verification/commands/commands.h"
#include "verification/scene/scene_template.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace wetfront::verification::commands {

int new_scene(const std::string& name, bool slide) {
  std::filesystem::path path = name;
  if (path.extension() != ".toml") path += ".toml";
  if (std::filesystem::exists(path))
    throw std::invalid_argument(path.string() + " exists already (it will not be overwritten). Choose another name");
  std::ofstream out(path);
  const std::string title = path.stem().string();
  out << (slide ? slide_template(title) : scene_template(title));
  if (!out.flush())
    throw std::runtime_error(path.string() +
                             " cannot be written (no such folder, or no permission). Choose another place");
  fmt::print("{} written. Try: wetfront check {}\n", path.string(), path.string());
  return 0;
}

}  // namespace wetfront::verification::commands
