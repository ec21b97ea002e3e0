#include "services/slicing/algo/section/local_width.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::local_width_test {
namespace {

struct Case {
  std::string name, outlines;
  std::string at;  ///< a point and the next one, on an edge
  double width_mm;
};

double WidthAt(const LocalWidth& width, Point p) {
  double least = INFINITY;
  for (const OutlineEdge& edge : width.edges()) {
    const double length = Distance(edge.from, edge.to);
    if (Distance(edge.from, p) + Distance(p, edge.to) > length + 2) continue;
    least = std::min(least, width.At(edge, p, width.Opposite(edge, p, p)));
  }
  return least;
}

TEST(LocalWidth, OfKnownShapes) {
  const char bar[] = "(0 0, 20 0, 20 1, 0 1)";
  const char frame[] = "(0 0, 20 0, 20 20, 0 20) (1 2, 18.5 2, 18.5 19, 1 19)";
  // The outline has two rooms with a door 0.6 mm wide between two corners.
  const char door[] = "(0 0, 10 0, 15 4.7, 20 0, 30 0, 30 10, 20 10, 15 5.3, 10 10, 0 10)";
  const char wedge[] = "(0 0, 20 -2, 20 2)";
  const std::vector<Case> cases = {
      {"Bar", bar, "(10 0, 0 0)", 1},
      {"BarOtherSide", bar, "(10 1, 0 0)", 1},
      {"BarEnd", bar, "(20 0.5, 0 0)", 3},
      {"BarCorner", bar, "(0.1 0, 0 0)", 1},
      {"FrameLeft", frame, "(0 10, 0 0)", 1},
      {"FrameBottom", frame, "(10 0, 0 0)", 2},
      {"FrameRight", frame, "(18.5 10, 0 0)", 1.5},
      {"DoorPost", door, "(15 4.7, 0 0)", 0.6},
      {"DoorOtherPost", door, "(15 5.3, 0 0)", 0.6},
      {"Room", door, "(5 0, 0 0)", 3},
      // The width is 2 t tan(half angle), where t is the distance along the side.
      {"Wedge", wedge, "(10 1, 0 0)", 2 * std::sqrt(101) * 0.1},
      {"WedgeTip", wedge, "(0 0, 1 1)", 0},
      {"ReflexCorner", "(0 0, 4 0, 4 -9, 30 -9, 30 9, 0 9)", "(4 0, 1 1)", 3},
      {"WideAngle", "(0 0, 20 -20, 20 20)", "(0.5 0.5, 0 0)", 3},
  };
  for (const Case& c : cases) {
    const MultiPolygon island = MakePolygonsOrDie(c.outlines);
    const LocalWidth width(island[0], 3'000'000, kBelow60Degrees);
    const Point p = MakeLineOrDie(c.at)[0];
    EXPECT_NEAR(WidthAt(width, p) * 1e-6, c.width_mm, 1e-3) << c.name;
  }
}

TEST(LocalWidth, CornersCountByTheirAngle) {
  const MultiPolygon island = MakePolygonsOrDie("(0 0, 20 -16, 20 16)");  // 77 degrees
  const Point p = MakeLineOrDie("(0.5 0.4, 0 0)")[0];
  const LocalWidth below60(island[0], 3'000'000, kBelow60Degrees);
  const LocalWidth below90(island[0], 3'000'000, kBelow90Degrees);
  EXPECT_EQ(WidthAt(below60, p), 3'000'000);
  EXPECT_NEAR(WidthAt(below90, p) * 1e-6, 2 * std::hypot(0.5, 0.4) * 0.8 / 0.848, 0.03);
}

TEST(LocalWidth, EdgesOfNoLengthAreLeftOut) {
  const LocalWidth width({{{0, 0}, {0, 0}, {5'000'000, 0}, {5'000'000, 5'000'000}}, {}}, 1'000'000,
                         kBelow60Degrees);
  EXPECT_EQ(width.edges().size(), 3u);
  EXPECT_TRUE(LocalWidth({}, 1, kBelow60Degrees).edges().empty());
}

}  // namespace
}  // namespace slicefarm::slicing::local_width_test
