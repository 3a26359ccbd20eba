#include "verification/run/sealed_file.h"

#include "verification/run/content_hash.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace wetfront::verification {

void write_sealed(const std::string& format, const std::vector<std::uint8_t>& content,
                  const std::filesystem::path& path) {
  ContentHash sum;
  sum.add(content);
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  // Two runs may write the same file at once: each moves its own into place.
  const std::filesystem::path draft = path.string() + "." + std::to_string(getpid());
  {
    std::ofstream out(draft, std::ios::binary);
    out << format << ' ' << sum.text() << '\n';
    out.write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (!out.flush()) throw std::runtime_error("cannot write " + draft.string() + " (is the disk full?)");
  }
  if (const int file = open(draft.c_str(), O_RDONLY); file >= 0) {
    fsync(file);
    close(file);
  }
  std::filesystem::rename(draft, path);
}

std::optional<std::vector<std::uint8_t>> read_sealed(const std::string& format, const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head;
  if (!std::getline(in, head)) return {};
  std::vector<std::uint8_t> content((std::istreambuf_iterator<char>(in)), {});
  ContentHash sum;
  sum.add(content);
  if (head != format + ' ' + sum.text()) return {};
  return content;
}

}  // namespace wetfront::verification
