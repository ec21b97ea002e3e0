#include "common/geometry/boolean/union_of_many.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::union_of_many_test {
namespace {

constexpr Coord kMm = kNmPerMm;

/// Paints a triangle with a round brush, as in the painting tool of a slicer. It divides the
/// triangle into four, `levels` times, where it meets the circle around the origin. It then adds
/// the pieces with their middle in the circle.
void Paint(const Polygon& t, double radius, int levels, std::vector<Polygon>& pieces) {
  const Point ab = {(t[0].x + t[1].x) / 2, (t[0].y + t[1].y) / 2};
  const Point bc = {(t[1].x + t[2].x) / 2, (t[1].y + t[2].y) / 2};
  const Point ca = {(t[2].x + t[0].x) / 2, (t[2].y + t[0].y) / 2};
  const auto corners = std::ranges::count_if(t, [&](Point p) { return Norm(p) < radius; });
  if (corners == 3 || levels == 0) {
    const Point middle = {(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
    if (Norm(middle) < radius) pieces.push_back(t);
    return;
  }
  for (const Polygon& part : {Polygon{t[0], ab, ca}, {ab, t[1], bc}, {bc, t[2], ca}, {ab, bc, ca}})
    Paint(part, radius, levels - 1, pieces);
}

/// Returns two faces with a common edge, painted with a round brush of 9 mm.
std::vector<Polygon> Painted(int levels) {
  std::vector<Polygon> pieces;
  Paint({{-10 * kMm, -11 * kMm}, {12 * kMm, -10 * kMm}, {11 * kMm, 13 * kMm}}, 9e6, levels, pieces);
  Paint({{-10 * kMm, -11 * kMm}, {11 * kMm, 13 * kMm}, {-12 * kMm, 11 * kMm}}, 9e6, levels, pieces);
  for (Polygon& piece : pieces)
    if (SignedArea(piece) < 0) std::ranges::reverse(piece);
  return pieces;
}

double SumOfAreas(const std::vector<Polygon>& rings) {
  double sum = 0;
  for (const Polygon& ring : rings) sum += SignedArea(ring);
  return sum;
}

TEST(UnionOfMany, IsThatOfUnion) {
  for (const int levels : {1, 3, 5, 7}) {
    const std::vector<Polygon> pieces = Painted(levels);
    const MultiPolygon want = Union(pieces, FillRule::kNonZero);
    const MultiPolygon got = UnionOfMany(pieces);
    ASSERT_FALSE(got.empty());
    const double differs = Area(Difference(want, got)) + Area(Difference(got, want));
    EXPECT_LT(differs, 20 * 2e7) << levels << ": a strip of 20 nm along the edge is more";
    EXPECT_NEAR(Area(got), SumOfAreas(pieces), 20 * 2e7) << "pieces lie side by side";
  }
}

TEST(UnionOfMany, TheOrderOfRingsChangesNothing) {
  std::vector<Polygon> pieces = Painted(6);
  const MultiPolygon want = UnionOfMany(pieces);
  std::mt19937 random(7);
  std::ranges::shuffle(pieces, random);
  for (Polygon& piece : pieces) std::rotate(piece.begin(), piece.begin() + 1, piece.end());
  EXPECT_EQ(UnionOfMany(pieces), want);
}

TEST(UnionOfMany, KeepsHolesAndIslands) {
  std::vector<Polygon> cells;  // a frame of 30 x 30 cells, one cell inside it, and one beside it
  const auto cell = [&](Coord x, Coord y) {
    cells.push_back({{x * kMm, y * kMm},
                     {(x + 1) * kMm, y * kMm},
                     {(x + 1) * kMm, (y + 1) * kMm},
                     {x * kMm, (y + 1) * kMm}});
  };
  for (Coord x = 0; x < 30; ++x)
    for (Coord y = 0; y < 30; ++y)
      if (x < 3 || x > 26 || y < 3 || y > 26) cell(x, y);
  cell(15, 15);
  cell(-9, 3);
  const MultiPolygon got = UnionOfMany(cells);
  ASSERT_EQ(got.size(), 3u);
  EXPECT_EQ(got, Union(cells, FillRule::kNonZero));
  EXPECT_EQ(Area(got), static_cast<double>(cells.size()) * 1e12);
  EXPECT_TRUE(UnionOfMany({}).empty());
}

/// Each sweep checks the token first.
TEST(UnionOfMany, StopsWhenCancelled) {
  const std::vector<Polygon> pieces = Painted(7);
  int64_t looks = 0;
  ASSERT_FALSE(UnionOfMany(pieces, CancelToken([&] { return ++looks < 0; })).empty());
  EXPECT_GE(looks * 32, std::ssize(pieces));
  for (const int64_t at : {int64_t{0}, int64_t{1}, looks / 2, looks - 1}) {
    int64_t asked = 0;
    EXPECT_TRUE(UnionOfMany(pieces, CancelToken([&] { return asked++ >= at; })).empty());
    EXPECT_LE(asked, at + 4) << "no sweep after it";
  }
}

}  // namespace
}  // namespace slicefarm::union_of_many_test
