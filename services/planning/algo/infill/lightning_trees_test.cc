#include "services/planning/algo/infill/lightning_trees.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::lightning_trees_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }
const RegionEdges& Square() {
  static const RegionEdges& square =
      *new RegionEdges(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)"));
  return square;
}

double LengthOf(const LightningTrees& branches) {
  double length = 0;
  for (const Polyline& line : branches.Lines(0)) length += Length(line);
  return ToMm(length);
}

TEST(LightningTrees, GrowFromTheEdgeOrFromATree) {
  LightningTrees branches;
  EXPECT_EQ(branches.GrowTo(Mm(8, 10), Square()), Mm(0, 10));
  EXPECT_EQ(branches.GrowTo(Mm(6, 12), Square()), Mm(6, 10));   // a new fork
  EXPECT_EQ(branches.GrowTo(Mm(10, 10), Square()), Mm(8, 10));  // the tip is extended
  EXPECT_EQ(branches.GrowTo(Mm(10, 2), Square()), Mm(10, 0));
  EXPECT_NEAR(LengthOf(branches), 10 + 2 + 2, 1e-6);
  const auto lines = branches.Lines(500'000);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].front(), Mm(-0.5, 10));
  EXPECT_EQ(lines[0].back(), Mm(10, 10));
}

TEST(LightningTrees, ShrinkOnTheWayDown) {
  LightningTrees branches;
  branches.GrowTo(Mm(5, 10), Square());
  branches.Descend(1e6, 1e6);
  EXPECT_NEAR(LengthOf(branches), 4, 1e-6);
  for (int i = 0; i < 4; ++i) branches.Descend(1e6, 1e6);
  EXPECT_TRUE(branches.nodes().empty());
}

TEST(LightningTrees, AForkOutlivesItsTwigs) {
  LightningTrees branches;
  branches.GrowTo(Mm(9, 10), Square());
  branches.GrowTo(Mm(5, 11.5), Square());
  branches.Descend(2e6, 2e6);
  EXPECT_NEAR(LengthOf(branches), 7, 1e-3);
}

TEST(LightningTrees, BendsStraighten) {
  LightningTrees branches;
  branches.GrowTo(Mm(4, 10), Square());
  branches.GrowTo(Mm(6.5, 12.5), Square());
  branches.GrowTo(Mm(10, 12.5), Square());
  const double before = LengthOf(branches);
  branches.Descend(0.2e6, 0.2e6);
  EXPECT_LT(LengthOf(branches), before - 0.2);
}

TEST(LightningTrees, AreTiedToAnotherRegion) {
  LightningTrees branches;
  branches.GrowTo(Mm(8, 10), Square());
  LightningTrees wider = branches;
  wider.Refit(RegionEdges(MakePolygonsOrDie("(-3 -3, 20 -3, 20 20, -3 20)")));
  EXPECT_NEAR(LengthOf(wider), 11, 1e-6);  // the wall has moved away
  LightningTrees narrower = branches;
  narrower.Refit(RegionEdges(MakePolygonsOrDie("(5 0, 20 0, 20 20, 5 20)")));
  EXPECT_NEAR(LengthOf(narrower), 3, 1e-6);
  LightningTrees across = branches;
  across.Refit(RegionEdges(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (2 8, 2 12, 4 12, 4 8)")));
  EXPECT_NEAR(LengthOf(across), 2 + 4, 0.01);  // a hole interrupts the line
  LightningTrees gone = branches;
  gone.Refit(RegionEdges({}));
  EXPECT_TRUE(gone.nodes().empty());
}

}  // namespace
}  // namespace slicefarm::planning::lightning_trees_test
