#include "services/infill/algo/skins/cover_index.h"

#include <gtest/gtest.h>

namespace slicefarm::infill::cover_index_test {
namespace {

/// Returns squares with sides of `size_nm` in rows of `in_row`, 12 mm apart.
MultiPolygon Squares(Coord in_row, Coord size_nm) {
  MultiPolygon squares;
  for (Coord i = 0; i < in_row * in_row; ++i) {
    const Point low{FromMm(12) * (i % in_row), FromMm(12) * (i / in_row)};
    const Point high{low.x + size_nm, low.y + size_nm};
    squares.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  }
  return squares;
}

TEST(CoverIndex, KeepsIslandsNearTheBoxAndEqualPointers) {
  const MultiPolygon own = Squares(10, FromMm(9)), other = Squares(10, FromMm(8));
  const MultiPolygon few = Squares(2, FromMm(8));
  const Cover cover{.above = {&own, &other, nullptr}, .below = {&other, &few}};
  const CoverIndex index(cover, &own);
  const Cover near = index.Near(Bounds(own[11].outer));
  ASSERT_EQ(near.above.size(), 3u);
  EXPECT_EQ(near.above[0], &own);
  EXPECT_EQ(*near.above[1], MultiPolygon{other[11]});
  EXPECT_EQ(near.above[2], nullptr);
  EXPECT_EQ(near.below[0], near.above[1]);
  EXPECT_EQ(near.below[1], &few);
  EXPECT_FALSE(index.Near({{-2, -2}, {-1, -1}}).above[1]->empty());
}

// Each island is divided by its neighbours above and below alone.
TEST(CoverIndex, SkinsAreTheSame) {
  const MultiPolygon own = Squares(10, FromMm(9)), above = Squares(10, FromMm(5));
  MultiPolygon below = Squares(10, FromMm(7));
  below.erase(below.begin() + 33);
  const Cover cover{.above = {&above}, .below = {&below}};
  const CoverIndex index(cover, &own);
  for (const size_t i : {0u, 32u, 33u, 99u}) {
    const MultiPolygon area = {own[i]};
    const Skins whole = PartFillArea(area, own, cover, {});
    const Skins near = PartFillArea(area, own, index.Near(Bounds(area)), {});
    EXPECT_EQ(whole.top, near.top);
    EXPECT_EQ(whole.bridge, near.bridge);
    EXPECT_EQ(whole.solid, near.solid);
    EXPECT_EQ(whole.sparse, near.sparse);
  }
}

// The whole layer above for each of 40,000 islands would take hours.
TEST(CoverIndex, ManyIslandsAreFast) {
  const MultiPolygon own = Squares(200, FromMm(9)), above = Squares(200, FromMm(9) + 1);
  const Cover cover{.above = {&above, &above}, .below = {&above}};
  const CoverIndex index(cover, &own);
  size_t sparse = 0;
  for (const PolygonWithHoles& island : own) {
    const MultiPolygon area = {island};
    sparse += PartFillArea(area, own, index.Near(Bounds(area)), {}).sparse == area ? 1 : 0;
  }
  EXPECT_EQ(sparse, own.size());
}

}  // namespace
}  // namespace slicefarm::infill::cover_index_test
