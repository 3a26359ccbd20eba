#pragma once

namespace wetfront::mpm {

/// The instruction set that this copy of the library was compiled for: "x86-64-v3" or "x86-64". The loader picks the
/// copy at start-up (mpm/CMakeLists.txt).
const char* instruction_set();

}  // namespace wetfront::mpm
