#include "meshes/rain_record.h"

#include <gtest/gtest.h>

namespace wetfront::meshes {
namespace {

const RainRecord shower{{10, 20, 40}, {1e-3, 0, 2e-3}};

TEST(RainRecord, IntensityHoldsFromItsStart) {
  EXPECT_EQ(intensity_after(shower, 0), 0);
  EXPECT_EQ(intensity_after(shower, 10), 1e-3);
  EXPECT_EQ(intensity_after(shower, 19.9), 1e-3);
  EXPECT_EQ(intensity_after(shower, 20), 0);
  EXPECT_EQ(intensity_after(shower, 1e6), 2e-3);
}

TEST(RainRecord, DepthIsTheExactIntegral) {
  EXPECT_EQ(depth_until(shower, 5), 0);
  EXPECT_DOUBLE_EQ(depth_until(shower, 15), 5e-3);
  EXPECT_DOUBLE_EQ(depth_until(shower, 30), 1e-2);
  EXPECT_DOUBLE_EQ(depth_until(shower, 50), 3e-2);
}

TEST(RainRecord, RainBeforeTimeZeroDoesNotCount) {
  EXPECT_DOUBLE_EQ(depth_until({{-100}, {1e-3}}, 10), 1e-2);
}

}  // namespace
}  // namespace wetfront::meshes
