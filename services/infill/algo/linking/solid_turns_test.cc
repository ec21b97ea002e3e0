#include "services/infill/algo/linking/solid_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::infill::solid_turns_test {
namespace {

constexpr double kPitch = 400'000;

/// Lines at an angle to the lower edge of a large square.
ScanLines LinesAt(const MultiPolygon& region, double degrees) {
  return *CutLines(region, {degrees * std::numbers::pi / 180, 200'000, kPitch});
}

/// Crossings of the lower edge, far from corners, from left to right.
std::vector<int32_t> LowerCrossings(const ScanLines& lines) {
  std::vector<int32_t> found;
  for (int32_t i = 0; i < std::ssize(lines.crossings); ++i) {
    const Point p = lines.PlaceOf(lines.crossings[i]);
    if (p.y < 10 && p.x > 10'000'000 && p.x < 30'000'000) found.push_back(i);
  }
  return found;
}

// How much longer the bead is than the room that its two lines have before the edge, half a pitch
// below the lines' region, in mm for each mm of edge.
double MoreThanTheRoom(double degrees) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)");
  const ScanLines lines = LinesAt(square, degrees);
  const std::vector<int32_t> at = LowerCrossings(lines);
  const SolidTurn turn = TurnBetween(lines, at[0], at[1], true);
  const auto line_end = [&](int32_t crossing, double back) {
    const double angle = degrees * std::numbers::pi / 180;
    return lines.PlaceOf(lines.crossings[crossing]) +
           Point{std::llround(back * std::cos(angle)), std::llround(back * std::sin(angle))};
  };
  const double bent = Distance(line_end(at[0], turn.from_back_nm), turn.way.front()) +
                      Length(turn.way) +
                      Distance(turn.way.back(), line_end(at[1], turn.to_back_nm));
  const double sine = std::sin(degrees * std::numbers::pi / 180);
  const double room = 2 * (kPitch / 2) / sine;
  return (bent - turn.from_back_nm - turn.to_back_nm - room) * kPitch / (2 * kPitch / sine) / 1e6;
}

// Half a pitch from the edge a turn holds what its room takes, and a little more at flat edges.
TEST(SolidTurn, HoldsThePlasticOfItsRoom) {
  for (const double degrees : {90.0, 80.0, 70.0, 60.0, 52.0, 45.0}) {
    EXPECT_GE(MoreThanTheRoom(degrees), 0) << degrees;
    EXPECT_LT(MoreThanTheRoom(degrees), 0.035) << degrees;
  }
  EXPECT_LT(MoreThanTheRoom(35), 0.06);
}

// Lines that lean to the right: the right end of a link moves to the right, into the wedge that its
// line would leave; the left one, over which its line leans, stays.
TEST(SolidTurn, TheEndBeforeAWedgeMovesIntoIt) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)");
  const ScanLines lines = LinesAt(square, 50);
  const std::vector<int32_t> at = LowerCrossings(lines);
  const Point left = lines.PlaceOf(lines.crossings[at[0]]);
  const Point right = lines.PlaceOf(lines.crossings[at[1]]);
  const SolidTurn turn = TurnBetween(lines, at[0], at[1], true);
  EXPECT_EQ(turn.way.front(), left);
  EXPECT_EQ(turn.from_back_nm, 0);
  EXPECT_GT(turn.way.back().x, right.x + 130'000);
  EXPECT_GT(turn.to_back_nm, kPitch / 2);
  for (const Point p : turn.way) EXPECT_NEAR(p.y, 0, 2);
}

// Where a bend would save next to nothing, it is no point of the path.
TEST(SolidTurn, NearlySquareEdgesHavePlainTurns) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)");
  for (const double degrees : {85.0, 90.0, 95.0}) {
    const ScanLines lines = LinesAt(square, degrees);
    const std::vector<int32_t> at = LowerCrossings(lines);
    const SolidTurn turn = TurnBetween(lines, at[0], at[1], true);
    EXPECT_EQ(turn.way.size(), 2u) << degrees;
    EXPECT_EQ(turn.from_back_nm + turn.to_back_nm, 0) << degrees;
  }
}

TEST(SolidTurn, BackwardsIsTheSame) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 8 0.2, 16.5 0, 24 1, 40 0, 40 40, 0 40)");
  for (const double degrees : {20.0, 50.0, 90.0, 130.0}) {
    const ScanLines lines = LinesAt(region, degrees);
    for (int32_t i = 0; i < std::ssize(lines.crossings); ++i) {
      const int32_t next = lines.crossings[i].next;
      const SolidTurn turn = TurnBetween(lines, i, next, true);
      SolidTurn back = TurnBetween(lines, next, i, false);
      std::ranges::reverse(back.way);
      ASSERT_EQ(turn.way.size(), back.way.size());
      for (size_t k = 0; k < turn.way.size(); ++k)
        EXPECT_LT(Distance(turn.way[k], back.way[k]), 3) << degrees;
      EXPECT_NEAR(turn.from_back_nm, back.to_back_nm, 1);
    }
  }
}

// Lines shorter than the bends, and edges in pieces shorter than the shifts.
TEST(SolidTurn, TakesLessThanHalfOfALine) {
  const MultiPolygon narrow = MakePolygonsOrDie("(0 0, 9 0.05, 9.1 0, 20 0, 20 0.5, 0 0.5)");
  const ScanLines lines = LinesAt(narrow, 40);
  for (int32_t i = 0; i < std::ssize(lines.crossings); ++i) {
    const Crossing& from = lines.crossings[i];
    const SolidTurn turn = TurnBetween(lines, i, from.next, true);
    ASSERT_GE(turn.way.size(), 1u);
    EXPECT_LT(turn.from_back_nm, 0.5 * lines.PieceLength(from.place / 2));
    EXPECT_LT(turn.to_back_nm, 0.5 * lines.PieceLength(lines.crossings[from.next].place / 2));
  }
}

}  // namespace
}  // namespace slicefarm::infill::solid_turns_test
