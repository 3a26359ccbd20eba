#include "verification/run/sealed_file.h"

#include "reports/whole_file.h"
#include "verification/run/content_hash.h"

#include <fstream>
#include <iterator>

namespace wetfront::verification {

void write_sealed(const std::string& format, const std::vector<std::uint8_t>& content,
                  const std::filesystem::path& path) {
  ContentHash sum;
  sum.add(content);
  if (path.has_parent_path()) reports::make_folder(path.parent_path());
  std::string text = format + ' ' + sum.text() + '\n';
  text.append(reinterpret_cast<const char*>(content.data()), content.size());
  reports::write_whole(path, text);
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
