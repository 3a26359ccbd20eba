#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace wetfront::meshes {

/// Walks through the words of a text file and knows where it is, for messages that name the place.
class Tokens {
 public:
  explicit Tokens(const std::filesystem::path& path);

  bool at_end();
  std::string word();         ///< throws at the end of the file
  std::string quoted_word();  ///< a word in double quotes, which may hold blanks
  long integer();
  long count();  ///< an integer >= 0 that the rest of the file could hold
  double real();
  /// Skips everything up to and including the word.
  void skip_past(const std::string& marker);

  /// `file:line:column: problem (why). suggestion` at the last word read.
  std::runtime_error error(const std::string& text) const;

 private:
  void skip_blanks();
  std::filesystem::path path_;
  std::string text_;
  std::size_t next_ = 0, word_start_ = 0;
};

}  // namespace wetfront::meshes
