#include "common/geometry/boolean/clipper_convert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

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

TEST(FromRings, GivesHolesToTheInnermostIslandAround) {
  const MultiPolygon nested = MakePolygonsOrDie(
      "(0 0, 90 0, 90 90, 0 90) (10 10, 80 10, 80 80, 10 80) ;"
      "(20 20, 70 20, 70 70, 20 70) (20 20, 60 30, 60 60, 30 60) ; (100 0, 110 0, 110 10)");
  std::vector<Polygon> rings;
  ForEachRing(nested, [&](const Polygon& ring) { rings.push_back(ring); });
  MultiPolygon want = nested;
  Canonicalize(want);
  for (size_t turn = 0; turn < rings.size(); ++turn) {
    std::rotate(rings.begin(), rings.begin() + 1, rings.end());
    EXPECT_EQ(FromRings(rings), want) << turn;
  }
}

TEST(ToPath, RoundTripsTheLargestCoordinates) {
  const Polygon ring = {{-2'100'000'000, 2'100'000'000}, {2'100'000'000, 0}, {0, 1}};
  EXPECT_EQ(FromPath(ToPath(ring)), ring);
}

}  // namespace
}  // namespace slicefarm::internal::clipper_convert_test
