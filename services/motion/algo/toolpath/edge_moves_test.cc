#include "services/motion/algo/toolpath/edge_moves.h"

#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion::edge_moves_test {
namespace {

/// Returns a square around a place, with walls of 10 mm.
Path Square(Coord x, int points = 4) {
  Path path;
  path.feature = Feature::kGapFill;
  path.closed = true;
  const Coord side = FromMm(10);
  path.points = {{x, 0}, {x + side, 0}, {x + side, side}};
  for (int i = 3; i < points; ++i)
    path.points.push_back({x + side - i * 100'000, side + i * 1'000});
  path.widths_nm = {450'000};
  return path;
}

Toolpath Built(const std::vector<Path>& paths) {
  static const MotionOptions options;
  ToolpathBuilder builder(options, {2, 600'000, 200'000}, 200'000);
  for (const Path& path : paths) builder.Add(path);
  return builder.Finish();
}

LayerEdges Edges(const Toolpath& path, ShiftUm shift = {}) {
  const MoveSpan whole = {&path, 0, path.moves.size(), shift};
  return EdgesOf({&whole, 1});
}

TEST(EdgesOf, AreTheFirstMovesAndTheLast) {
  const Toolpath path = Built({Square(0), Square(FromMm(50), 50)});
  const LayerEdges edges = Edges(path, {1'000, 2'000});
  ASSERT_EQ(edges.approach, 2);
  ASSERT_EQ(edges.head.size(), 3 + kEdgeMoves);
  EXPECT_EQ(edges.head[0].z_um, 400) << "the layer before";
  EXPECT_EQ(edges.head[1].z_um, 600);
  EXPECT_EQ(edges.head[2].x_um, 1'000);
  EXPECT_EQ(edges.head[2].y_um, 2'000);
  EXPECT_FALSE(Prints(edges.head[2], edges.head[3])) << "the filament comes back";
  EXPECT_TRUE(Prints(edges.head[3], edges.head[4]));
  EXPECT_EQ(edges.head[4].feature, Feature::kGapFill);
  ASSERT_EQ(edges.tail.size(), 1 + kEdgeMoves);
  EXPECT_LT(edges.tail.back().filament, 0) << "retracts";
  EXPECT_EQ(edges.tail.back().x_um, 51'000);
}

TEST(EdgesOf, OfAShortLayerAreAllOfIt) {
  const LayerEdges edges = Edges(Built({Square(0)}));
  EXPECT_EQ(edges.head.size(), 9);
  EXPECT_EQ(edges.tail.size(), 7) << "from the entry on";
  EXPECT_EQ(edges.tail.back(), edges.head.back());
}

TEST(EdgesOf, NothingHasNone) { EXPECT_EQ(EdgesOf({}), LayerEdges()); }

TEST(ToKinematic, OfWhatStandsStillIsNothing) {
  EXPECT_FALSE(ToKinematic({.x_um = 5}, {.x_um = 5}, 1000));
  const auto filament = ToKinematic({}, {.filament = -80'000, .feed_rate = 600}, 1000);
  ASSERT_TRUE(filament);
  EXPECT_TRUE(filament->ExtruderOnly());
  EXPECT_DOUBLE_EQ(filament->length_mm, 0.8);
  EXPECT_EQ(filament->acceleration_mm_s2, 1000);
}

}  // namespace
}  // namespace slicefarm::motion::edge_moves_test
