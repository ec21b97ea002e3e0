#include "services/exposure/algo/decompose/cgal_partition.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::cgal_partition_test {
namespace {

TEST(CgalPartition, OfAnL) {
  const Polygon ring = MakePolygonsOrDie("(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)")[0].outer;
  for (const DecomposeMethod method :
       {DecomposeMethod::kOptimal, DecomposeMethod::kApproximate, DecomposeMethod::kYMonotone}) {
    const auto pieces = CgalPartition(ring, method);
    ASSERT_TRUE(pieces);
    // The number of monotone parts need not be the least one.
    if (method == DecomposeMethod::kYMonotone)
      EXPECT_LE(pieces->size(), 3u);
    else
      EXPECT_EQ(pieces->size(), 2u);
    double area = 0;
    for (const Polygon& piece : *pieces) area += SignedArea(piece);
    EXPECT_EQ(area, 300e12);
  }
}

/// The tip of each tooth begins a monotone part. A partition that ignores y needs fewer parts.
TEST(CgalPartition, MonotonePartsOfAComb) {
  const Polygon comb =
      MakePolygonsOrDie("(0 0, 50 0, 50 30, 40 10, 30 30, 20 10, 10 30, 5 10, 0 20)")[0].outer;
  const auto pieces = CgalPartition(comb, DecomposeMethod::kYMonotone);
  ASSERT_TRUE(pieces);
  const auto fewest = CgalPartition(comb, DecomposeMethod::kOptimal);
  ASSERT_TRUE(fewest);
  EXPECT_GE(pieces->size(), fewest->size());
  double area = 0;
  for (const Polygon& piece : *pieces) area += SignedArea(piece);
  EXPECT_EQ(area, SignedArea(comb));
}

/// A plate with a hole that was cut open: CGAL 5.5's monotone partition follows invalid pointers on
/// it.
TEST(CgalPartition, HasNothingToSayOfPolygonsThatTouchThemselves) {
  const Polygon cut_open =
      MakePolygonsOrDie("(0 0, 40 0, 40 20, 0 20, 0 0, 5 5, 5 15, 15 15, 15 5, 5 5)")[0].outer;
  const Polygon corner_on_edge =
      MakePolygonsOrDie("(0 0, 20 0, 20 10, 10 0, 10 20, 0 20)")[0].outer;
  for (const DecomposeMethod method :
       {DecomposeMethod::kOptimal, DecomposeMethod::kApproximate, DecomposeMethod::kYMonotone}) {
    EXPECT_FALSE(CgalPartition(cut_open, method));
    EXPECT_FALSE(CgalPartition(corner_on_edge, method));
  }
}

}  // namespace
}  // namespace slicefarm::exposure::cgal_partition_test
