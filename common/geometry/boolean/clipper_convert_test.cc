#include "common/geometry/boolean/clipper_convert.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::internal::clipper_convert_test {
namespace {

TEST(FromTree, KeepsIslandsInHolesApart) {
  // A frame, an island in its hole, a hole in that island, and an island in that hole.
  const MultiPolygon nested = MakePolygonsOrDie(
      "(0 0, 90 0, 90 90, 0 90) (10 10, 80 10, 80 80, 10 80) ;"
      "(20 20, 70 20, 70 70, 20 70) (30 30, 60 30, 60 60, 30 60) ; (40 40, 50 40, 50 50, 40 50)");
  ClipperLib::Paths paths;
  AppendRings(nested, paths);
  EXPECT_EQ(paths.size(), 5u);
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  MultiPolygon islands = FromTree(tree);
  MultiPolygon want = nested;
  Canonicalize(want);
  EXPECT_EQ(islands, want);
}

TEST(ToPath, RoundTripsTheLargestCoordinates) {
  const Polygon ring = {{-2'100'000'000, 2'100'000'000}, {2'100'000'000, 0}, {0, 1}};
  EXPECT_EQ(FromPath(ToPath(ring)), ring);
}

}  // namespace
}  // namespace slicefarm::internal::clipper_convert_test
