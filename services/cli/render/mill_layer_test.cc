#include "services/cli/render/mill_layer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm::cli::mill_layer_test {
namespace {

using testing::HasSubstr;

constexpr char kProgram[] =
    "; tool 1: cyl:2, 9000 rpm\n"
    "G21 G17 G90\nT1 M6\nG0 Z9.000\nS9000 M3\nG4 P3\n"
    "(roughing)\n"
    "G0 X0.000 Y0.000\nZ4.000\nG1 Z3.000 F300.000\nX10.000 F800.000\nY5.000\n"
    "G0 Z9.000\nX0.000\nZ3.000\nG1 Z2.000 F300.000\nX4.000 F800.000\n"
    "G3 X0.000 Y4.000 I-4.000 J0.000\n"
    "(rest areas)\n"
    "G1 X1.000 Z2.500\nX2.000\n"
    "M9\nM5\nM2\n; stepdown = 1\n";

TEST(ReadMillLayer, HasTheWaysOfALevel) {
  ASSERT_TRUE(IsMillProgram(kProgram));
  const auto top = ReadMillLayer(kProgram, 0);
  ASSERT_TRUE(top.ok()) << top.status();
  EXPECT_EQ(top->layer_count, 2);
  EXPECT_EQ(top->z_mm, 3);
  ASSERT_EQ(top->beads.size(), 1u);
  EXPECT_EQ(top->beads[0].feature, "roughing");
  EXPECT_EQ(top->beads[0].points, (std::vector<Vector2>{{0, 0}, {10, 0}, {10, 5}}));
  EXPECT_TRUE(top->travels.empty()) << "rapid moves are higher";
  const auto low = ReadMillLayer(kProgram, 1);
  ASSERT_TRUE(low.ok()) << low.status();
  ASSERT_EQ(low->beads.size(), 1u);
  EXPECT_GT(low->beads[0].points.size(), 10u) << "an arc";
  EXPECT_EQ(low->beads[0].points.back(), (Vector2{0, 4}));
}

TEST(ReadMillLayer, HasAllWays) {
  const auto all = ReadMillLayer(kProgram, std::nullopt);
  ASSERT_TRUE(all.ok()) << all.status();
  EXPECT_EQ(all->beads.size(), 4u);
  EXPECT_EQ(all->beads.back().feature, "rest areas");
  EXPECT_EQ(all->travels.size(), 1u);
}

TEST(ReadMillLayer, TakesNoChordOfARampForALevel) {
  const auto all = ReadMillLayer(
      "; tool 1: cyl:2\n(roughing)\nG0 X0.000 Y0.000\nZ4.000\nG1 Z3.000 F300.000\nX0.010\n"
      "X1.000 Z2.500\nX1.010\nX2.000 Z2.000\nX9.000\n",
      std::nullopt);
  ASSERT_TRUE(all.ok()) << all.status();
  EXPECT_EQ(all->layer_count, 1);
  EXPECT_EQ(all->z_mm, 2);
}

TEST(ReadMillLayer, NamesTheLastLevel) {
  for (const int level : {-1, 2}) {
    const absl::Status status = ReadMillLayer(kProgram, level).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
    EXPECT_THAT(std::string(status.message()), HasSubstr("0 to 1"));
  }
  EXPECT_FALSE(ReadMillLayer("; tool 1\nG0 X1\nG1 Xnan Y1e99 Z\n", std::nullopt).ok());
  EXPECT_FALSE(IsMillProgram("G1 X1\n"));
}

}  // namespace
}  // namespace slicefarm::cli::mill_layer_test
