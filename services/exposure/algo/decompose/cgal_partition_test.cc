#include "services/exposure/algo/decompose/cgal_partition.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::exposure::cgal_partition_test {
namespace {

TEST(CgalPartition, OfAnL) {
  const Polygon ring = MakePolygonsOrDie("(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)")[0].outer;
  for (const DecomposeMethod method :
       {DecomposeMethod::kOptimal, DecomposeMethod::kApproximate, DecomposeMethod::kYMonotone}) {
    const auto pieces = CgalPartition(ring, method);
    ASSERT_TRUE(pieces.ok()) << pieces.status();
    // Monotone parts need not be the fewest.
    if (method == DecomposeMethod::kYMonotone)
      EXPECT_LE(pieces->size(), 3u);
    else
      EXPECT_EQ(pieces->size(), 2u);
    double area = 0;
    for (const Polygon& piece : *pieces) area += SignedArea(piece);
    EXPECT_EQ(area, 300e12);
  }
}

/// Each tooth's tip starts a part of its own, which a partition without regard to y has no need of.
TEST(CgalPartition, MonotonePartsOfAComb) {
  const Polygon comb = MakePolygonsOrDie(
      "(0 0, 50 0, 50 30, 40 10, 30 30, 20 10, 10 30, 5 10, 0 20)")[0].outer;
  const auto pieces = CgalPartition(comb, DecomposeMethod::kYMonotone);
  ASSERT_TRUE(pieces.ok()) << pieces.status();
  const auto fewest = CgalPartition(comb, DecomposeMethod::kOptimal);
  ASSERT_TRUE(fewest.ok()) << fewest.status();
  EXPECT_GE(pieces->size(), fewest->size());
  double area = 0;
  for (const Polygon& piece : *pieces) area += SignedArea(piece);
  EXPECT_EQ(area, SignedArea(comb));
}

}  // namespace
}  // namespace slicefarm::exposure::cgal_partition_test
