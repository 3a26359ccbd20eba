#pragma once

#include "reports/record.h"

#include <string>

/// result.json: the stored form of a Record. result.schema.json documents it, README.md tells when its version changes.
///
/// Numbers that JSON lacks are strings: "NaN", "Infinity", "-Infinity". All others read back to the same double.
namespace wetfront::reports {

inline constexpr const char* result_schema = "wetfront-result/1";

/// One line per finding, figure and table, so that the file can be read and compared by eye.
std::string to_json(const Record& record);

/// Throws std::runtime_error saying what is wrong: no JSON, another schema, a missing or mistyped key.
Record from_json(const std::string& text);

/// "pass", "fail", "inconclusive", "info"
const char* verdict_key(Verdict verdict);
/// Back again. Throws std::runtime_error.
Verdict verdict_from(const std::string& key);

}  // namespace wetfront::reports
