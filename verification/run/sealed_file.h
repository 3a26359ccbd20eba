#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// Writes bytes behind a line with the format's name and a check sum, whole or not at all: into a file of its own
/// that is on the disk before it is moved into place. Throws std::runtime_error when it cannot.
void write_sealed(const std::string& format, const std::vector<std::uint8_t>& content,
                  const std::filesystem::path& path);

/// Absent where there is no such file, or not a whole one of this format.
std::optional<std::vector<std::uint8_t>> read_sealed(const std::string& format, const std::filesystem::path& path);

}  // namespace wetfront::verification
