#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace wetfront::reports::testing {

/// Where `value` breaks `schema`, one line each; empty when it conforms. A member that the schema does not
/// document is a violation too (stricter than the standard, which lets it pass). Knows the keywords that
/// result.schema.json uses (type, const, enum, properties, required, additionalProperties, items, anyOf, $ref into
/// $defs) and throws std::logic_error on any other, so that no promise of the schema goes unchecked.
std::vector<std::string> violations(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace wetfront::reports::testing
