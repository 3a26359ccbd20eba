#pragma once

#include "reports/record.h"

#include <nlohmann/json.hpp>

/// Pictures and films in result.json; a film's numbers are base64 of little-endian 16-bit words.
namespace wetfront::reports {

nlohmann::ordered_json picture_json(const FieldPicture& picture);
FieldPicture picture_from(const nlohmann::ordered_json& json);

nlohmann::ordered_json film_json(const Film& film);
/// Throws std::runtime_error when the numbers are not as many as frames, channels and points ask for.
Film film_from(const nlohmann::ordered_json& json);

/// "line", "dashed", "points"
const char* style_key(Series::Style style);
nlohmann::ordered_json series_json(const Series& series);
Series series_from(const nlohmann::ordered_json& json);

}  // namespace wetfront::reports
