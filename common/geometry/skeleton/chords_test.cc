#include "common/geometry/skeleton/chords.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/skeleton/axis_tracer.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::chords_test {
namespace {

/// Returns the axis of an area with a reflex corner 1 mm above a flat floor.
SkeletalGraph Axis() {
  const auto boundary = MakeBoundary(MakePolygonsOrDie("(0 0, 8 0, 8 6, 4 1, 0 6)")[0]);
  auto axis = TraceAxis(*boundary);
  EXPECT_TRUE(axis.has_value());
  axis->boundary = boundary->EdgesInNm();
  return *axis;
}

TEST(Chords, AreLinkedLikeTheirCurves) {
  const SkeletalGraph axis = Axis();
  const SkeletalGraph graph = WithChords(axis, {.tolerance_nm = 1'000});
  ASSERT_GT(graph.half_edges.size(), axis.half_edges.size());
  EXPECT_EQ(graph.nodes.size() - axis.nodes.size(),
            (graph.half_edges.size() - axis.half_edges.size()) / 2);
  for (int half = 0; half < static_cast<int>(graph.half_edges.size()); ++half) {
    const HalfEdge& edge = graph.half_edges[half];
    ASSERT_EQ(graph.half_edges[edge.next].previous, half);
    ASSERT_EQ(graph.half_edges[edge.next].from, graph.To(half));
  }
}

TEST(Chords, StartAndEndAtTheNodesOfTheAxis) {
  const SkeletalGraph axis = Axis();
  const SkeletalGraph graph = WithChords(axis, {});
  ASSERT_GE(graph.nodes.size(), axis.nodes.size());
  EXPECT_TRUE(std::equal(axis.nodes.begin(), axis.nodes.end(), graph.nodes.begin(),
                         [](const SkeletalNode& a, const SkeletalNode& b) {
                           return a.place == b.place && a.radius == b.radius;
                         }));
}

TEST(Chords, AStraightAxisHasNone) {
  const auto boundary = MakeBoundary(MakePolygonsOrDie("(0 0, 5 0, 5 1, 0 1)")[0]);
  const auto axis = TraceAxis(*boundary);
  ASSERT_TRUE(axis.has_value());
  EXPECT_EQ(WithChords(*axis, {.step_nm = 1'000}).half_edges.size(), axis->half_edges.size());
}

}  // namespace
}  // namespace slicefarm::chords_test
