#include "services/exposure/algo/scan/outline_check.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::outline_check_test {
namespace {

/// Two squares of 10 mm with 2 mm between them.
const char kSquares[] = "(0 0, 10 0, 10 10, 0 10); (12 0, 22 0, 22 10, 12 10)";

Point At(double x, double y) { return {FromMm(x), FromMm(y)}; }

bool Strays(ExposureKind kind, std::vector<Point> line, const ExposureOptions& options = {},
            const char* outline = kSquares) {
  std::vector<ExposureGroup> groups(1);
  groups[0].kind = kind;
  groups[0].AddLine(std::vector{At(5, 5), At(6, 6)});
  groups[0].AddLine(line);
  const auto stray = FindStray(groups, MakePolygonsOrDie(outline), options);
  if (stray) {
    EXPECT_EQ(stray->kind, kind);
  }
  return stray.has_value();
}

TEST(FindStray, ByKindAndDistance) {
  for (const ExposureKind kind :
       {ExposureKind::kContour, ExposureKind::kHatch, ExposureKind::kUpskin}) {
    EXPECT_FALSE(Strays(kind, {At(0.04, 5), At(0.04, 6)}));
    EXPECT_TRUE(Strays(kind, {At(0.036, 5), At(0.036, 6)}));
    EXPECT_FALSE(Strays(kind, {At(0.04, 5), At(9.96, 5)}));
    EXPECT_TRUE(Strays(kind, {At(0.04, 5), At(9.97, 5)}));
  }
  EXPECT_FALSE(Strays(ExposureKind::kThinWall, {At(0.001, 5), At(0.001, 6)}));
  EXPECT_TRUE(Strays(ExposureKind::kThinWall, {At(-0.001, 5), At(5, 6)}));
}

TEST(FindStray, OverAGapWithBothEndsInside) {
  for (const ExposureKind kind :
       {ExposureKind::kContour, ExposureKind::kHatch, ExposureKind::kThinWall})
    EXPECT_TRUE(Strays(kind, {At(5, 5), At(17, 5)}));
  EXPECT_TRUE(Strays(ExposureKind::kHatch, {At(5, 5), At(9, 5), At(17, 5), At(9, 5)}));
}

TEST(FindStray, WithoutCompensationContoursLieOnTheOutline) {
  ExposureOptions options;
  options.beam_compensation_nm = 0;
  const std::vector<Point> on = {At(0, 0), At(10, 0), At(10, 10), At(0, 10), At(0, 0)};
  EXPECT_FALSE(Strays(ExposureKind::kContour, on, options));
  EXPECT_TRUE(Strays(ExposureKind::kContour, {At(-0.004, 0), At(5, 5)}, options));
  EXPECT_TRUE(Strays(ExposureKind::kContour, {At(5, 5), At(17, 5)}, options));
  EXPECT_TRUE(Strays(ExposureKind::kContour, {At(10, 5), At(12, 5)}, options));
  EXPECT_FALSE(Strays(ExposureKind::kHatch, {At(0, 5), At(10, 5)}, options));
  EXPECT_TRUE(Strays(ExposureKind::kHatch, {At(0, 5), At(22, 5)}, options));
  EXPECT_TRUE(Strays(ExposureKind::kThinWall, {At(-0.001, 5), At(5, 6)}, options));
}

TEST(FindStray, SaysWhichVector) {
  std::vector<ExposureGroup> groups(2);
  groups[1].points = {At(1, 1), At(2, 1), At(5, 5), At(17, 5)};  // hatch lines
  const auto stray = FindStray(groups, MakePolygonsOrDie(kSquares), {});
  ASSERT_TRUE(stray);
  EXPECT_EQ(stray->from, At(5, 5));
  EXPECT_EQ(stray->to, At(17, 5));
}

}  // namespace
}  // namespace slicefarm::exposure::outline_check_test
