#include "meshes/msh_tokens.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>

namespace wetfront::meshes {

Tokens::Tokens(const std::filesystem::path& path) : path_(path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::runtime_error(path.string() + ":1:1: the mesh cannot be read (no such file, or no permission). " +
                             "Give a path relative to the scene, or an absolute one");
  text_.assign(std::istreambuf_iterator<char>(in), {});
}

void Tokens::skip_blanks() {
  while (next_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[next_]))) ++next_;
}

bool Tokens::at_end() {
  skip_blanks();
  return next_ == text_.size();
}

std::string Tokens::word() {
  skip_blanks();
  word_start_ = next_;
  if (next_ == text_.size()) throw error("the mesh file ends too early (a value was expected). Write the mesh again");
  while (next_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[next_]))) ++next_;
  return text_.substr(word_start_, next_ - word_start_);
}

std::string Tokens::quoted_word() {
  skip_blanks();
  word_start_ = next_;
  const auto end = next_ < text_.size() && text_[next_] == '"' ? text_.find('"', next_ + 1) : std::string::npos;
  if (end == std::string::npos) throw error("a name in double quotes was expected (physical groups are named so)");
  next_ = end + 1;
  return text_.substr(word_start_ + 1, end - word_start_ - 1);
}

long Tokens::integer() {
  const std::string text = word();
  long value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size())
    throw error("'" + text + "' is not a whole number (one was expected). Is this an ASCII mesh?");
  return value;
}

long Tokens::count() {
  const long value = integer();
  if (value < 0 || value > static_cast<long>(text_.size()))
    throw error(std::to_string(value) + " entries cannot be in this file (it is too short). Write the mesh again");
  return value;
}

double Tokens::real() {
  const std::string text = word();
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || !(value - value == 0))
    throw error("'" + text + "' is not a finite number (a coordinate was expected). Is this an ASCII mesh?");
  return value;
}

void Tokens::skip_past(const std::string& marker) {
  const auto found = text_.find(marker, next_);
  if (found == std::string::npos) {
    throw error("'" + marker + "' is missing (the section is not closed). Write the mesh again");
  }
  next_ = found + marker.size();
}

std::runtime_error Tokens::error(const std::string& text) const {
  const auto place = text_.begin() + static_cast<std::ptrdiff_t>(word_start_);
  const auto line = 1 + std::count(text_.begin(), place, '\n');
  const auto line_start = std::find(std::make_reverse_iterator(place), text_.rend(), '\n').base();
  const auto column = 1 + (place - line_start);
  return std::runtime_error(path_.string() + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + text);
}

}  // namespace wetfront::meshes
