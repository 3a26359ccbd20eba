#pragma once

#include <string>

namespace wetfront::verification {

/// How every scene written by `wetfront new` begins: where its numbers come from, title, requirement, gravity, and how
/// values are written.
std::string headed_template(const std::string& name, const std::string& requirement);

/// A commented scene to start from: a column in the rain (`wetfront new NAME`).
std::string scene_template(const std::string& name);

/// One of a slope from the first rain to the end of its slide (`wetfront new NAME --slide`).
std::string slide_template(const std::string& name);

}  // namespace wetfront::verification
