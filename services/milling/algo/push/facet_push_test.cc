#include "services/milling/algo/push/facet_push.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::facet_push_test {
namespace {

struct FacetCase {
  const char* name;
  const char* cutter;
  double end;
};

/// The triangle is a large part of the plane height = along.
TEST(PushFacet, TouchesASlope) {
  const std::array<FiberPoint, 3> corners = {FiberPoint{-50, -50, -50}, {50, -40, 50}, {0, 80, 0}};
  for (const FacetCase& c :
       {FacetCase{"ball", "ball:2", 1 - std::sqrt(2)}, FacetCase{"cylinder", "cyl:2", -1},
        FacetCase{"bull", "bull:2:0.25", -0.75 - 0.25 * (std::sqrt(2) - 1)},
        FacetCase{"cone, at its tip", "cone:2:30", 0},
        FacetCase{"cone, at its rim", "cone:2:60", std::sqrt(1 / 3.0) - 1}}) {
    const FacetContact contact = PushFacet(CutterOf(c.cutter), corners, NormalOf(corners));
    EXPECT_EQ(contact.side, -1) << c.name;
    EXPECT_NEAR(contact.end, c.end, 1e-12) << c.name;
    EXPECT_NEAR(contact.at.height, contact.at.along, 1e-12) << c.name;
  }
}

/// A cone touches a gentle slope with its tip, also on the slope's lowest side.
TEST(PushFacet, TouchesTheLowestSideWithItsTip) {
  const std::array<FiberPoint, 3> corners = {FiberPoint{2, -5, 0}, {2, 5, 0}, {6, 0, 1}};
  const FacetContact contact = PushFacet(CutterOf("cone:2:45"), corners, NormalOf(corners));
  EXPECT_EQ(contact.side, -1);
  EXPECT_NEAR(contact.end, 2, 1e-12);
}

TEST(PushFacet, LeavesLevelAndUprightOnesToTheirEdges) {
  const Cutter cutter = CutterOf("ball:2");
  for (const std::array<FiberPoint, 3>& corners :
       {std::array{FiberPoint{-9, -9, 0.5}, FiberPoint{9, -9, 0.5}, FiberPoint{0, 9, 0.5}},
        std::array{FiberPoint{0, -9, -5}, FiberPoint{0, 9, -5}, FiberPoint{0, 0, 9}},
        std::array{FiberPoint{0, 0, 0}, FiberPoint{1, 1, 1}, FiberPoint{2, 2, 2}},
        std::array{FiberPoint{1, 1, 1}, FiberPoint{1, 1, 1}, FiberPoint{1, 1, 1}}}) {
    EXPECT_EQ(PushFacet(cutter, corners, NormalOf(corners)).side, 0);
  }
}

}  // namespace
}  // namespace slicefarm::milling::facet_push_test
