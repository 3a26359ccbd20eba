#pragma once

#include "verification/scene/complaints.h"

#include <string>
#include <vector>

/// The TOML document as plain data with places. document.cpp is the only unit that includes toml++.
namespace wetfront::verification {

struct Entry;

struct Value {
  enum class Kind { table, array, text, integer, real, boolean, date };
  Kind kind = Kind::table;
  Place place;
  Place end;                   ///< behind its last character (of a section: of its header)
  std::string text;            ///< of Kind::text
  double number = 0;           ///< of integer, real and boolean
  std::vector<Entry> entries;  ///< of a table
  std::vector<Value> items;    ///< of an array

  const Entry* find(const std::string& key) const;
  bool is_number() const { return kind == Kind::integer || kind == Kind::real; }
  /// What the file says, short enough for a message: `"1.2 m"`, `40`, `{ law = ... }`.
  std::string shown() const;
};

struct Entry {
  std::string key;
  Place place;  ///< of the key
  Value value;
};

/// Parses TOML. Throws SceneError in the grammar of read.h when it is none.
Value parse_document(const std::string& text, const std::string& file);

}  // namespace wetfront::verification
