#include "reports/base64.h"

#include <cstdint>
#include <stdexcept>

namespace wetfront::reports {

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::uint32_t digit(char c) {
  const std::size_t at = digits.find(c);
  if (at == std::string_view::npos) throw std::runtime_error("not base64: a character stands there that it lacks");
  return static_cast<std::uint32_t>(at);
}

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
  std::vector<unsigned char> bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const std::size_t padding = i + 4 < text.size() ? 0 : (text[i + 3] == '=') + (text[i + 2] == '=');
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 4; ++k) group = group << 6 | (k < 4 - padding ? digit(text[i + k]) : 0);
    for (std::size_t k = 0; k < 3 - padding; ++k) bytes.push_back(static_cast<unsigned char>(group >> (16 - 8 * k)));
  }
  return bytes;
}

}  // namespace wetfront::reports
