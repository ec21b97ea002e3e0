#include "services/motion/algo/toolpath/bridge_thread.h"

#include <gtest/gtest.h>

#include "common/model/bead_section.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::bridge_thread_test {
namespace {

Path Bead(Coord width_nm, Feature feature = Feature::kBridgeInfill) {
  Path path;
  path.feature = feature;
  path.widths_nm = {width_nm};
  return path;
}

/// Returns the width of a bead of 0.2 mm height with the plastic of a thread of 0.4 mm.
Coord WidthOfThread() { return WidthForSpacing(FromMm(DiscMm2(0.4) / 0.2), 200'000); }

TEST(BridgeThread, IsKnownByItsPlastic) {
  MotionOptions options;
  EXPECT_EQ(ThreadNm(Bead(WidthOfThread()), 200'000, options), 400'000);
  EXPECT_EQ(ThreadNm(Bead(450'000), 200'000, options), 0) << "lies on a support";
  EXPECT_EQ(ThreadNm(Bead(WidthOfThread(), Feature::kSolidInfill), 200'000, options), 0);
  options.speeds[0].bridge_flow = 0.81;
  EXPECT_EQ(ThreadNm(Bead(WidthOfThread()), 200'000, options), 0) << "its threads are thinner";
  EXPECT_DOUBLE_EQ(ThreadMm(options.speeds[0], 0.4), 0.36);
}

TEST(BridgeThread, OverSparseInfillByItsOwnFlow) {
  MotionOptions options;
  const Path bead = Bead(WidthOfThread(), Feature::kInternalBridge);
  EXPECT_EQ(ThreadNm(bead, 200'000, options), 400'000);
  options.speeds[0].internal_bridge_flow = 0.81;
  EXPECT_EQ(ThreadNm(bead, 200'000, options), 0);
  options.speeds[0].internal_bridge_flow = 1;
  options.speeds[0].bridge_flow = 0.81;
  EXPECT_EQ(ThreadNm(bead, 200'000, options), 400'000);
}

// The width of the settings is the strand's diameter at a flow of 1.
TEST(BridgeThread, HasTheWidthOfTheSettings) {
  RegionMotion region;
  region.bridge_width_mm = 0.3;
  EXPECT_DOUBLE_EQ(ThreadMm(region, 0.4), 0.3);
  region.bridge_flow = 0.81;
  EXPECT_DOUBLE_EQ(ThreadMm(region, 0.4), 0.27);
}

}  // namespace
}  // namespace slicefarm::motion::bridge_thread_test
