#include "services/motion/algo/program/machine_space.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::motion::machine_space_test {
namespace {

Polygon Ring(const char* text) {
  Polygon ring = MakePolygonsOrDie(text)[0].outer;
  return ring;
}

TEST(MachineSpace, BoxAndHeight) {
  const MachineSpace space(Ring("(0 0, 200 0, 200 100, 0 100)"), 150, -0.5);
  EXPECT_LE(space.Outside(200, 100, 150), 0);
  EXPECT_DOUBLE_EQ(space.Outside(201.5, 50, 1), 1.5);
  EXPECT_DOUBLE_EQ(space.Outside(100, -3, 1), 3);
  EXPECT_DOUBLE_EQ(space.Outside(100, 50, 152), 2);
  EXPECT_DOUBLE_EQ(space.Outside(100, 50, -0.75), 0.25);
}

TEST(MachineSpace, ConvexBedsAreExactOthersTheirBox) {
  const MachineSpace diamond(Ring("(0 -10, 10 0, 0 10, -10 0)"), 0, 0);
  EXPECT_GT(diamond.Outside(9, 9, 0), 0);
  const MachineSpace notched(Ring("(0 0, 10 0, 5 5, 10 10, 0 10)"), 0, 0);
  EXPECT_LE(notched.Outside(9, 5, 0), 0);
}

TEST(MachineSpace, NotKnown) { EXPECT_LE(MachineSpace({}, 0, 0).Outside(1e6, 1e6, 1e6), 0); }

}  // namespace
}  // namespace slicefarm::motion::machine_space_test
