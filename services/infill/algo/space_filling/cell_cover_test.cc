#include "services/infill/algo/space_filling/cell_cover.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::cell_cover_test {
namespace {

constexpr Coord kCell = 900'000;

Polygon SquareOf(const CellCover& cover, Coord column, Coord row, Coord side = 1) {
  const Point low = cover.origin + Point{column * cover.cell_nm, row * cover.cell_nm};
  const Coord s = side * cover.cell_nm;
  return {low, low + Point{s, 0}, low + Point{s, s}, low + Point{0, s}};
}

std::vector<MultiPolygon> RandomRegions(int count) {
  std::mt19937 random(7);
  std::vector<MultiPolygon> regions;
  for (int i = 0; i < count; ++i) {
    regions.push_back(
        RandomIsland(random, {Coord{i % 5} * 3'100'000, -1'700'000}, Uniform(random, 2, 20)));
  }
  return regions;
}

TEST(CellCover, BoxOnTheGrid) {
  // An edge along the grid touches the cells on both sides.
  const CellCover cover =
      CoverOf(MakePolygonsOrDie("(-0.1 -0.1, 3.7 -0.1, 3.7 1.9, -0.1 1.9)"), kCell, 2);
  int inside = 0;
  for (const char cell : cover.inside) inside += cell;
  EXPECT_EQ(inside, 8);
  EXPECT_EQ(
      OutlineOf(cover),
      (std::vector<Polygon>{{{3'600'000, 0}, {3'600'000, 1'800'000}, {0, 1'800'000}, {0, 0}}}));
}

TEST(CellCover, HasTheCellsThatLieInside) {
  const std::vector<MultiPolygon> regions = RandomRegions(40);
  ASSERT_EQ(regions.size(), 40u);
  int inside = 0;
  for (const MultiPolygon& region : regions) {
    const CellCover cover = CoverOf(region, kCell, 2);
    for (int32_t row = 0; row < cover.rows; ++row) {
      for (int32_t column = 0; column < cover.columns; ++column) {
        const MultiPolygon cell = {{SquareOf(cover, column, row), {}}};
        const double covered = Area(Intersection(region, cell)) / Area(cell);
        EXPECT_EQ(cover.Has(column, row), covered > 1 - 1e-9) << column << " " << row;
        inside += cover.Has(column, row) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 0);
}

TEST(CellCover, BlocksAreTheCellsAndAligned) {
  const std::vector<MultiPolygon> regions = RandomRegions(40);
  ASSERT_EQ(regions.size(), 40u);
  for (const uint32_t base : {2U, 3U}) {
    for (const MultiPolygon& region : regions) {
      const CellCover cover = CoverOf(region, kCell, base);
      std::vector<char> left = cover.inside;
      for (const CellBlock& block : LargestBlocks(cover, base)) {
        EXPECT_EQ(block.first.x % block.side, 0U);
        EXPECT_EQ(block.first.y % block.side, 0U);
        for (uint32_t y = 0; y < block.side; ++y) {
          for (uint32_t x = 0; x < block.side; ++x) {
            const auto column = static_cast<int32_t>(block.first.x + x - cover.first.x);
            const auto row = static_cast<int32_t>(block.first.y + y - cover.first.y);
            ASSERT_TRUE(cover.Has(column, row));
            char& cell = left[static_cast<size_t>(row) * cover.columns + column];
            ASSERT_EQ(cell, 1);
            cell = 0;
          }
        }
      }
      EXPECT_EQ(std::count(left.begin(), left.end(), 1), 0);
    }
  }
}

TEST(CellCover, AFullSquareIsOneBlock) {
  for (const auto& [base, side] : {std::pair{2U, 16U}, std::pair{3U, 27U}}) {
    CellCover cover{.cell_nm = kCell, .first = {base * side, 5 * side}};
    cover.columns = cover.rows = static_cast<int32_t>(side);
    cover.inside.assign(uint64_t{side} * side, 1);
    EXPECT_EQ(LargestBlocks(cover, base),
              (std::vector<CellBlock>{{{base * side, 5 * side}, side}}));
  }
}

TEST(CellCover, OutlineIsTheCellsUnion) {
  const std::vector<MultiPolygon> regions = RandomRegions(40);
  ASSERT_EQ(regions.size(), 40u);
  for (const MultiPolygon& region : regions) {
    const CellCover cover = CoverOf(region, kCell, 2);
    std::vector<Polygon> squares;
    for (int32_t row = 0; row < cover.rows; ++row)
      for (int32_t column = 0; column < cover.columns; ++column)
        if (cover.Has(column, row)) squares.push_back(SquareOf(cover, column, row));
    const MultiPolygon want = Union(squares, FillRule::kNonZero);
    const MultiPolygon got = Union(OutlineOf(cover), FillRule::kNonZero);
    EXPECT_EQ(Area(Difference(want, got)) + Area(Difference(got, want)), 0);
    EXPECT_EQ(Area(got), static_cast<double>(squares.size()) * kCell * kCell);
  }
}

TEST(CellCover, CornersThatTouch) {
  CellCover cover{.cell_nm = 10, .columns = 2, .rows = 2, .inside = {1, 0, 0, 1}};
  EXPECT_EQ(OutlineOf(cover).size(), 2U);
  cover.inside = {0, 1, 1, 0};
  EXPECT_EQ(OutlineOf(cover).size(), 2U);
}

TEST(CellCover, OfNothing) {
  const CellCover cover = CoverOf({}, kCell, 2);
  EXPECT_TRUE(LargestBlocks(cover, 2).empty());
  EXPECT_TRUE(OutlineOf(cover).empty());
}

}  // namespace
}  // namespace slicefarm::infill::cell_cover_test
