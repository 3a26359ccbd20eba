#include "mpm/isa.h"

namespace wetfront::mpm {

const char* instruction_set() {
#if defined(__AVX2__) && defined(__FMA__)
  return "x86-64-v3";
#else
  return "x86-64";
#endif
}

}  // namespace wetfront::mpm
