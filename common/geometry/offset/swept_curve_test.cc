#include "common/geometry/offset/swept_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::internal::swept_curve_test {
namespace {

// The corner at (4, 4) is reflex, all others are convex.
const Polygon kL = MakePolygonsOrDie("(0 0, 10 0, 10 4, 4 4, 4 10, 0 10)")[0].outer;

// With long edges, the curve of a ring with a reflex corner does not cross itself.
TEST(SweptCurve, IsTheInsetOfWideRings) {
  const SweptCurve curve = SweepInwards(kL, 1e6);
  EXPECT_EQ(curve.points, MakeLineOrDie("(1 1, 9 1, 9 3, 3 3, 3 9, 1 9)"));
  EXPECT_EQ(curve.edges, 6);
}

TEST(SweptCurve, HasArcsAtReflexCornersIfAsked) {
  const SweptCurve miters = SweepInwards(kL, 1e6), arcs = SweepInwards(kL, 1e6, 100);
  const double corner = (1 - std::numbers::pi / 4) * 1e12;
  EXPECT_NEAR(SignedArea(arcs.points) - SignedArea(miters.points), corner, 0.001 * corner);
  const double nearest = 1e6 - 100 - 2;
  for (size_t i = 0; i < arcs.points.size(); ++i)
    EXPECT_GE(DistanceToSegment({FromMm(4), FromMm(4)}, arcs.points[i],
                                arcs.points[(i + 1) % arcs.points.size()]),
              nearest);
}

TEST(SweptCurve, TellsThePartOfEachEdge) {
  const SweptCurve curve = SweepInwards(kL, 1e6, 100);
  ASSERT_EQ(curve.parts.size(), curve.points.size());
  int arc = 0;
  for (size_t i = 0; i < curve.parts.size(); ++i) {
    const Point from = curve.points[i], to = curve.points[(i + 1) % curve.points.size()];
    if (curve.parts[i] % 2 == 1) {
      EXPECT_EQ(curve.parts[i], 5);  // the corner after edge 2
      ++arc;
      continue;
    }
    const size_t edge = static_cast<size_t>(curve.parts[i] / 2);
    const Point along = kL[(edge + 1) % kL.size()] - kL[edge];
    EXPECT_EQ(Cross(along, to - from), 0) << i;
    EXPECT_GT(Dot(along, to - from), 0) << i;
  }
  EXPECT_GT(arc, 10);
}

TEST(SweptCurve, IsEmptyIfTheRingReverses) {
  EXPECT_TRUE(SweepInwards(MakeLineOrDie("(0 0, 10 0, 4 0)"), 1e6).points.empty());
}

}  // namespace
}  // namespace slicefarm::internal::swept_curve_test
