#pragma once

/// The texts of page.css and page.js, compiled in by CMakeLists.txt.
namespace wetfront::reports {

extern const char* const page_css;
extern const char* const page_js;

}  // namespace wetfront::reports
