#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace wetfront::verification {

/// FNV-1a, 64 bits: names a content, protects nothing. Lengths are part of the content, so that two lists cannot be
/// mistaken for one.
class ContentHash {
 public:
  void add_bytes(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ ^= static_cast<unsigned char>(byte);
      value_ *= 1099511628211ull;
    }
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void add(Number number) { add_bytes({reinterpret_cast<const char*>(&number), sizeof number}); }
  void add(std::string_view text) {
    add(text.size());
    add_bytes(text);
  }
  template <class Number, std::size_t n>
  void add(const std::array<Number, n>& numbers) {
    for (const Number& number : numbers) add(number);
  }
  template <class Entry>
  void add(const std::vector<Entry>& entries) {
    add(entries.size());
    if constexpr (std::is_arithmetic_v<Entry>) {
      add_bytes({reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(Entry)});
    } else {
      for (const Entry& entry : entries) add(entry);
    }
  }
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t value_ = 14695981039346656037ull;
};

}  // namespace wetfront::verification
