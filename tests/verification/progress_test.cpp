#include "verification/run/progress.h"

#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

TEST(Pace, ARunThatGoesOnKnowsNothingOfWhatCameBefore) {
  Pace pace;
  EXPECT_LT(pace.left("rain", 8000, 10000, 0), 0);
  EXPECT_DOUBLE_EQ(pace.left("rain", 8200, 10000, 10), 90);
}

TEST(Pace, EachStageHasItsOwn) {
  Pace pace;
  pace.left("rain", 0, 10000, 0);
  EXPECT_DOUBLE_EQ(pace.left("rain", 5000, 10000, 50), 50);
  EXPECT_LT(pace.left("slide", 5000, 5010, 50), 0);
  EXPECT_DOUBLE_EQ(pace.left("slide", 5001, 5010, 70), 180);
}

}  // namespace
}  // namespace wetfront::verification
