#include "services/milling/algo/push/fiber_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::fiber_frame_test {
namespace {

/// The test compares a triangle's interval on random fibers with a dense sample of the triangle. At
/// its ends the cutter does not gouge any sample and is near to some; contacts are on the cutter.
TEST(FiberFrame, PushesAgainstTrianglesAsASampleTells) {
  std::mt19937 random(11);
  int hits = 0;
  for (int round = 0; round < 60; ++round) {
    TriangleMesh mesh = RandomTriangle(random, 4);
    if (round % 6 == 0) mesh.points_mm[1].z() = mesh.points_mm[2].z() = mesh.points_mm[0].z() + 0.3;
    if (round % 6 == 1) mesh.points_mm[1].head<2>() = mesh.points_mm[0].head<2>();
    const MeshEdges edges = EdgesOf(mesh);
    for (const FiberAxis axis : {FiberAxis::kX, FiberAxis::kY}) {
      const FiberFrame frame(mesh, edges, axis);
      for (const std::string_view text : kAllCutters) {
        const Cutter cutter = CutterOf(text);
        const Fiber fiber{0.3, -0.2};
        const Interval found = frame.PushTriangle(cutter, 0, fiber);
        if (!(found.low < found.high)) continue;
        ++hits;
        for (const bool high : {false, true}) {
          const double end = high ? found.high : found.low;
          const Eigen::Vector3d tip = axis == FiberAxis::kX
                                          ? Eigen::Vector3d(end, fiber.across_mm, fiber.z_mm)
                                          : Eigen::Vector3d(fiber.across_mm, end, fiber.z_mm);
          const double clearance = SampledClearance(mesh, cutter, tip, 60);
          EXPECT_GE(clearance, -1e-9) << text << " " << round;
          const Source& source = high ? found.high_source : found.low_source;
          const Eigen::Vector3d contact = frame.ContactOf(cutter, source, fiber, high) - tip;
          EXPECT_NEAR(contact.head<2>().norm(), cutter.Width(std::max(0.0, contact.z())), 1e-9)
              << text << " " << round;
        }
      }
    }
  }
  EXPECT_GT(hits, 200);
}

}  // namespace
}  // namespace slicefarm::milling::fiber_frame_test
