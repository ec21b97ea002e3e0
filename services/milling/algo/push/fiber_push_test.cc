#include "services/milling/algo/push/fiber_push.h"

#include <gtest/gtest.h>

#include <vector>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::fiber_push_test {
namespace {

void ExpectSame(const FiberIntervals& a, const FiberIntervals& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t fiber = 0; fiber < a.size(); ++fiber) {
    ASSERT_EQ(a[fiber].size(), b[fiber].size()) << fiber;
    for (size_t i = 0; i < a[fiber].size(); ++i) {
      EXPECT_EQ(a[fiber][i].low, b[fiber][i].low) << fiber;
      EXPECT_EQ(a[fiber][i].high, b[fiber][i].high) << fiber;
    }
  }
}

/// A level's result depends neither on the levels above it nor on the threads, exactly.
TEST(PushFibers, LevelsStandForThemselves) {
  TriangleMesh mesh = Sphere(5);
  Append(mesh, Box({3, 3, -4}, {9, 8, 6}));
  const MeshEdges edges = EdgesOf(mesh);
  const FiberGrid grid{-14, 0.31, 100};
  std::vector<double> levels;
  for (double z = 6.5; z > -6; z -= 0.37) levels.push_back(z);
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    const FiberFrame frame(mesh, edges, FiberAxis::kX);
    const auto together = PushFibers(frame, cutter, grid, levels, 2, {});
    ASSERT_TRUE(together.ok());
    for (size_t level = 0; level < levels.size(); level += 5) {
      const auto alone = PushFibers(frame, cutter, grid, std::vector{levels[level]}, 1, {});
      ASSERT_TRUE(alone.ok());
      ExpectSame((*alone)[0], (*together)[level]);
    }
  }
}

/// The expected result is the union over all triangles, computed without any optimization.
TEST(PushFibers, IsTheUnionOverAllTriangles) {
  const TriangleMesh mesh = Waves(8, 12);
  const MeshEdges edges = EdgesOf(mesh);
  const FiberGrid grid{-5, 0.37, 50};
  const std::vector<double> levels = {0.6, 0.1, -0.8};
  for (const FiberAxis axis : {FiberAxis::kX, FiberAxis::kY}) {
    const FiberFrame frame(mesh, edges, axis);
    for (const std::string_view text : kAllCutters) {
      const Cutter cutter = CutterOf(text);
      const auto pushed = PushFibers(frame, cutter, grid, levels, 1, {});
      ASSERT_TRUE(pushed.ok());
      for (size_t level = 0; level < levels.size(); ++level) {
        FiberIntervals brute;
        for (int32_t i = 0; i < grid.count; ++i) {
          IntervalSet set;
          for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Interval one = frame.PushTriangle(cutter, t, {grid.At(i), levels[level]});
            if (one.low < one.high) set.Add(one);
          }
          brute.push_back(set.items());
        }
        ExpectSame((*pushed)[level], brute);
      }
    }
  }
}

TEST(PushFibers, CanBeCancelled) {
  const TriangleMesh mesh = Sphere(5);
  const MeshEdges edges = EdgesOf(mesh);
  const FiberFrame frame(mesh, edges, FiberAxis::kX);
  const auto pushed = PushFibers(frame, CutterOf("ball:4"), {-9, 0.1, 180}, std::vector{0.0}, 1,
                                 CancelToken([] { return true; }));
  EXPECT_EQ(pushed.status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::milling::fiber_push_test
