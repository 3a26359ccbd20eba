#pragma once

#include "reports/record.h"

#include <filesystem>
#include <string>

namespace wetfront::reports {

/// The picture as an element of a page: panels side by side, each field in bands of colour, legends beneath.
/// `pressure_per_head` [kPa/m]: legends of pressures carry metres of water, too; 0: they do not.
std::string picture_html(const FieldPicture& picture, double pressure_per_head);

/// `<id>.svg`, all panels in a row, and `<id>.csv`: a node a line, x, y and a column per panel.
void write_picture(const FieldPicture& picture, const std::filesystem::path& folder);

/// Throws std::runtime_error unless ids are stems, arrays fit each other and cells name nodes that exist.
void check(const FieldPicture& picture);

}  // namespace wetfront::reports
