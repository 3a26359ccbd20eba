#include "reports/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

namespace wetfront::reports {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<int, 256> values = [] {
  std::array<int, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) table[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  return table;
}();

}  // namespace

std::string base64(std::span<const unsigned char> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t group = bytes[i] << 16 | (left > 1 ? bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
    text += digits[group >> 18];
    text += digits[group >> 12 & 63];
    text += left > 1 ? digits[group >> 6 & 63] : '=';
    text += left > 2 ? digits[group & 63] : '=';
  }
  return text;
}

std::vector<unsigned char> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) throw std::runtime_error("not base64: its length is no multiple of four");
  const std::size_t end = std::min(text.size(), text.find_first_not_of(digits));
  if (text.size() - end > 2 || text.find_first_not_of('=', end) != std::string_view::npos)
    throw std::runtime_error("not base64: a character stands there that it lacks");
  return from_base64_parts(text);
}

std::vector<unsigned char> from_base64_parts(std::string_view text) {
  std::vector<unsigned char> bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int held = 0;  // bits of the group that are not yet in a byte
  for (const char c : text) {
    if (c == '=') held = 0;
    const int value = values[static_cast<unsigned char>(c)];
    if (value < 0) continue;
    group = group << 6 | static_cast<std::uint32_t>(value);
    if ((held += 6) < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<unsigned char>(group >> held & 0xFF));
  }
  return bytes;
}

}  // namespace wetfront::reports
