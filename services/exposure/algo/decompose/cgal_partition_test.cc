#include "services/exposure/algo/decompose/cgal_partition.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::exposure {
namespace {

TEST(CgalPartition, OfAnL) {
  const Polygon ring = MakePolygonsOrDie("(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)")[0].outer;
  for (const DecomposeMethod method : {DecomposeMethod::kOptimal, DecomposeMethod::kApproximate}) {
    const auto pieces = CgalPartition(ring, method);
    ASSERT_TRUE(pieces.ok()) << pieces.status();
    EXPECT_EQ(pieces->size(), 2u);
    double area = 0;
    for (const Polygon& piece : *pieces) area += SignedArea(piece);
    EXPECT_EQ(area, 300e12);
  }
}

}  // namespace
}  // namespace slicefarm::exposure
