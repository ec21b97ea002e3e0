#include "common/model/path.h"

#include <gtest/gtest.h>

namespace slicefarm {
namespace {

TEST(Path, LengthOfClosedCountsTheClosingEdge) {
  Path path;
  path.points = {{0, 0}, {3, 0}, {3, 4}};
  path.widths_nm = {450};
  EXPECT_EQ(PathLength(path), 7);
  path.closed = true;
  EXPECT_EQ(PathLength(path), 12);
  EXPECT_EQ(path.WidthAt(2), 450);
}

TEST(FeatureName, IsWhatPreviewersRead) {
  EXPECT_EQ(FeatureName(Feature::kExternalPerimeter), "External perimeter");
  EXPECT_EQ(FeatureName(Feature::kTopSolidInfill), "Top solid infill");
  EXPECT_EQ(FeatureName(Feature::kSupport), "Support material");
}

}  // namespace
}  // namespace slicefarm
