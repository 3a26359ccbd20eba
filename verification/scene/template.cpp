#include "verification/scene/read.h"
