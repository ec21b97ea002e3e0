#include "common/model/path.h"

#include <gtest/gtest.h>

namespace slicefarm::path_test {
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

TEST(Path, EndsWhereItStartsIfClosed) {
  Path path;
  path.points = {{1, 2}, {3, 4}};
  EXPECT_EQ(StartOf(path), (Point{1, 2}));
  EXPECT_EQ(EndOf(path), (Point{3, 4}));
  path.closed = true;
  EXPECT_EQ(EndOf(path), (Point{1, 2}));
}

TEST(Path, HasTwoPointsAndAWidthForAllOrEach) {
  Path path;
  path.points = {{0, 0}, {3, 0}, {3, 4}};
  for (const size_t widths : {0, 1, 2, 3, 4}) {
    path.widths_nm.assign(widths, 450);
    EXPECT_EQ(WellFormed(path), widths == 1 || widths == 3) << widths;
  }
  path.points.resize(1);
  path.widths_nm = {450};
  EXPECT_FALSE(WellFormed(path));
}

TEST(FeatureType, IsWhatPreviewersRead) {
  EXPECT_EQ(FeatureType(Feature::kExternalPerimeter), "External perimeter");
  EXPECT_EQ(FeatureType(Feature::kTopSolidInfill), "Top solid infill");
  EXPECT_EQ(FeatureType(Feature::kSupport), "Support material");
  EXPECT_EQ(FeatureType(Feature::kSupportInterface), "Support material interface");
  EXPECT_EQ(FeatureType(Feature::kIroning), "Ironing");
  EXPECT_EQ(FeatureType(Feature::kSolidOverBridge), "Solid infill");
  EXPECT_EQ(FeatureName(Feature::kSolidOverBridge), "Solid infill over bridge");
}

}  // namespace
}  // namespace slicefarm::path_test
