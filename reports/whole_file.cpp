#include "reports/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace wetfront::reports {

namespace {

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& path, int error) {
  throw std::runtime_error(path.string() + ": cannot " + what + " (" + std::strerror(error) + ")");
}

/// Closes, removes the temporary file and reports `path`, the file the caller asked for.
[[noreturn]] void give_up(int file, const std::string& temporary, const std::filesystem::path& path, int error) {
  if (file >= 0) ::close(file);
  ::unlink(temporary.c_str());
  fail("write", path, error);
}

const std::string temporary_ending = ".part";  // and the writer's process number

bool is_temporary(const std::string& name) {
  const std::size_t at = name.rfind(temporary_ending);
  if (at == std::string::npos) return false;
  const std::string number = name.substr(at + temporary_ending.size());
  return !number.empty() && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c); });
}

}  // namespace

void write_whole(const std::filesystem::path& path, std::string_view content) {
  const std::string temporary = path.string() + temporary_ending + std::to_string(::getpid());
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("write", path, errno);
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) give_up(file, temporary, path, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file) != 0 && errno != EINVAL) give_up(file, temporary, path, errno);
  if (::close(file) != 0) give_up(-1, temporary, path, errno);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) give_up(-1, temporary, path, errno);
}

void clear_half_written(const std::filesystem::path& folder) {
  std::error_code none;
  std::vector<std::filesystem::path> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (is_temporary(entry.path().filename().string())) left.push_back(entry.path());
  for (const auto& file : left) std::filesystem::remove(file, none);
}

std::string read_whole(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", path, errno ? errno : EIO);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file.good() || text.fail()) {
    // An empty file also fails the insertion; only a folder or a broken disk is an error.
    if (std::filesystem::is_directory(path)) fail("read", path, EISDIR);
    if (file.bad()) fail("read", path, EIO);
  }
  return std::move(text).str();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail("make the folder", folder, error.value());
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "wetfront_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail("make the folder", name, errno);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace wetfront::reports
