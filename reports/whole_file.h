#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace wetfront::reports {

/// Writes `content` beside `path`, flushes it to the disk and renames it into place, so that a reader sees the old
/// file or the new one, never half of either. Throws std::runtime_error naming the file and the system's reason.
void write_whole(const std::filesystem::path& path, std::string_view content);

/// Removes from `folder` (not from those in it) what writers that were killed inside write_whole left there; no other
/// process may be writing to it.
void clear_half_written(const std::filesystem::path& folder);

/// Throws std::runtime_error naming the file and the system's reason.
std::string read_whole(const std::filesystem::path& path);

/// Creates the folder and its parents. Throws std::runtime_error naming it and the system's reason.
void make_folder(const std::filesystem::path& folder);

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace wetfront::reports
