#include "services/motion/algo/toolpath/jerks.h"

#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::jerks_test {
namespace {

MotionOptions Options() {
  MotionOptions options;
  options.limits.max_jerk_mm_s = {20, 15, 0.4, 2.5};
  options.jerk.feature_mm_s[static_cast<size_t>(Feature::kExternalPerimeter)] = 7;
  return options;
}

TEST(Jerks, WithoutADefaultTheFirmwareDecides) {
  const Jerks jerks = JerksFor(Options(), Ground::kLayers);
  EXPECT_FALSE(jerks.written);
  EXPECT_EQ(jerks.Print(Feature::kExternalPerimeter), 0);
}

TEST(Jerks, FeaturesThenDefault) {
  MotionOptions options = Options();
  options.jerk.default_mm_s = 9;
  const Jerks jerks = JerksFor(options, Ground::kLayers);
  EXPECT_TRUE(jerks.written);
  EXPECT_EQ(jerks.Print(Feature::kExternalPerimeter), 7);
  EXPECT_EQ(jerks.Print(Feature::kInternalInfill), 9);
  EXPECT_EQ(jerks.Travel(9), 9) << "the jerk set last";
}

TEST(Jerks, TheFirstLayerHasItsOwn) {
  MotionOptions options = Options();
  options.jerk.default_mm_s = 9;
  options.jerk.travel_mm_s = 12;
  options.jerk.first_layer_mm_s = 5;
  EXPECT_EQ(JerksFor(options, Ground::kBed).Print(Feature::kExternalPerimeter), 5);
  EXPECT_EQ(JerksFor(options, Ground::kBed).Travel(9), 5);
  EXPECT_EQ(JerksFor(options, Ground::kRaft).Print(Feature::kExternalPerimeter), 7);
  EXPECT_EQ(JerksFor(options, Ground::kLayers).Travel(9), 12);
  options.jerk.first_layer_travel_mm_s = 6;
  EXPECT_EQ(JerksFor(options, Ground::kBed).Travel(9), 6);
}

TEST(Jerks, TheMachineLimitsThem) {
  MotionOptions options = Options();
  options.jerk.default_mm_s = 18;
  EXPECT_EQ(JerksFor(options, Ground::kLayers).Print(Feature::kInternalInfill), 15);
  options.limits.max_jerk_mm_s[1] = 0;
  EXPECT_EQ(JerksFor(options, Ground::kLayers).Print(Feature::kInternalInfill), 18);
  EXPECT_EQ(JerksFor(options, Ground::kLayers).OfAxes(9), (std::array<double, 4>{9, 9, 0.4, 2.5}));
}

}  // namespace
}  // namespace slicefarm::motion::jerks_test
