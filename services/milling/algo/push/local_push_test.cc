#include "services/milling/algo/push/local_push.h"

#include <gtest/gtest.h>

#include <set>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::local_push_test {
namespace {

TEST(TriangleGrid, FindsAllInABox) {
  const TriangleMesh mesh = Waves(8, 20);
  const TriangleGrid grid(mesh);
  for (const double x : {-1.0, 0.0, 3.3, 7.9, 12.0}) {
    const Eigen::Vector2d low(x, 1.2), high(x + 1, 4.4);
    std::set<uint32_t> found;
    grid.ForEachIn(low, high, [&](uint32_t t) { found.insert(t); });
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      bool in = false;
      for (const uint32_t p : mesh.triangles[t]) {
        const Eigen::Vector2d q = mesh.points_mm[p].head<2>();
        in |= (q.array() >= low.array()).all() && (q.array() <= high.array()).all();
      }
      EXPECT_TRUE(!in || found.contains(t)) << t;
    }
  }
}

TEST(PushLocally, IsWhatTheWholeFiberHasThere) {
  const TriangleMesh mesh = Waves(8, 16);
  const MeshEdges edges = EdgesOf(mesh);
  const TriangleGrid grid(mesh);
  const FiberFrame frame(mesh, edges, FiberAxis::kY);
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    const Fiber fiber{3.3, 0.2};
    IntervalSet whole;
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Interval one = frame.PushTriangle(cutter, t, fiber);
      if (one.low < one.high) whole.Add(one);
    }
    for (double at = -3; at < 11; at += 0.23) {
      const IntervalSet local = PushLocally(frame, cutter, grid, fiber, at, at);
      EXPECT_EQ(local.Covers(at, at), whole.Covers(at, at)) << text << " " << at;
    }
  }
}

}  // namespace
}  // namespace slicefarm::milling::local_push_test
