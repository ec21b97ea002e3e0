#include "common/geometry/skeleton/axis_order.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/geometry/skeleton/axis_tracer.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::axis_order_test {
namespace {

SkeletalGraph Axis() {
  const auto boundary = MakeBoundary(MakePolygonsOrDie(
      "(0 0, 9 0, 9 3, 5 3, 5.5 8, 1 7, 3 4) (6 1, 8 1, 7 2) (2 6, 4 6, 4 7)")[0]);
  auto axis = TraceAxis(*boundary);
  EXPECT_TRUE(axis.has_value());
  return *std::move(axis);
}

void ExpectInSweepOrder(const SkeletalGraph& axis) {
  ASSERT_GT(axis.half_edges.size(), 20u);
  const auto passed = [&](int half) {
    return axis.FromNode(half).place.x() + axis.FromNode(half).radius;
  };
  for (int half = 0; half < static_cast<int>(axis.half_edges.size()); half += 2) {
    EXPECT_GE(passed(half), passed(half + 1));
    if (half > 0) {
      EXPECT_GE(passed(half + 1), passed(half - 1));
    }
    EXPECT_EQ(axis.half_edges[axis.half_edges[half].next].previous, half);
    EXPECT_EQ(axis.half_edges[axis.half_edges[half].next].from, axis.To(half));
  }
}

TEST(AxisOrder, IsThatOfASweepFromLeftToRight) {
  SkeletalGraph axis = Axis();
  ExpectInSweepOrder(axis);
  // Exchanges two edges.
  const int last = static_cast<int>(axis.half_edges.size()) - 2;
  for (int i = 0; i < 2; ++i) std::swap(axis.half_edges[i], axis.half_edges[last + i]);
  for (HalfEdge& edge : axis.half_edges) {
    for (int* link : {&edge.next, &edge.previous}) {
      if (*link < 2)
        *link += last;
      else if (*link >= last)
        *link -= last;
    }
  }
  ExpectInSweepOrder(InSweepOrder(axis));
}

TEST(AxisOrder, EdgesWithoutNodesAreLeftOut) {
  SkeletalGraph axis = Axis();
  const size_t halves = axis.half_edges.size();
  axis.half_edges.push_back({-1, -1, -1, 0, false});
  axis.half_edges.push_back({-1, -1, -1, 0, false});
  const SkeletalGraph ordered = InSweepOrder(axis);
  EXPECT_EQ(ordered.half_edges.size(), halves);
  ExpectInSweepOrder(ordered);
}

}  // namespace
}  // namespace slicefarm::axis_order_test
