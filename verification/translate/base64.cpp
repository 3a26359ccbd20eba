#include "verification/translate/base64.h"

#include <array>
#include <cstdint>

namespace wetfront::verification {

std::string from_base64(const std::string& text) {
  static const std::array<int, 256> digit = [] {
    std::array<int, 256> table;
    table.fill(-1);
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i) table[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
    return table;
  }();
  std::string bytes;
  std::uint32_t group = 0;
  int held = 0;  // bits of the group that are not yet in a byte
  for (const char c : text) {
    if (c == '=') held = 0;
    const int value = digit[static_cast<unsigned char>(c)];
    if (value < 0) continue;
    group = group << 6 | static_cast<std::uint32_t>(value);
    if ((held += 6) < 8) continue;
    held -= 8;
    bytes += static_cast<char>(group >> held & 0xFF);
  }
  return bytes;
}

}  // namespace wetfront::verification
