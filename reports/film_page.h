#pragma once

#include "reports/record.h"

#include <filesystem>
#include <string>

namespace wetfront::reports {

/// The film as an element of a page: three still frames as drawings, and the data from which the page's script makes a
/// player. `pressure_per_head` as in picture_html().
std::string film_html(const Film& film, double pressure_per_head);

/// Those three frames in a row, as `<id>_stills.svg`: for papers; and `<id>_stills.csv`, the points that they show.
void write_stills(const Film& film, const std::filesystem::path& folder);

}  // namespace wetfront::reports
