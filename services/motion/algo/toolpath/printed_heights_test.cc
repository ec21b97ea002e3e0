#include "services/motion/algo/toolpath/printed_heights.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::printed_heights_test {
namespace {

constexpr Coord kTip = 400'000, kLowest = -150'000;

TEST(PrintedHeights, HoldTheNozzleAboveBeadsUnderItsTip) {
  PrintedHeights printed(kTip);
  EXPECT_EQ(printed.LeastUp({0, 0}, kLowest), kLowest);
  printed.Add({300'000, 0}, -40'000);
  EXPECT_EQ(printed.LeastUp({0, 0}, kLowest), -40'000);
  printed.Add({0, 300'000}, -20'000);
  EXPECT_EQ(printed.LeastUp({0, 0}, kLowest), -20'000);
  printed.Add({0, 300'000}, -60'000);
  EXPECT_EQ(printed.LeastUp({0, 0}, kLowest), -20'000) << "the highest bead of a square counts";
}

TEST(PrintedHeights, AreBelowTheConeFartherAway) {
  PrintedHeights printed(kTip);
  printed.Add({500'000, 100'000}, 0);  // the middle of a square
  EXPECT_EQ(printed.LeastUp({0, 100'000}, kLowest), -100'000) << "0.1 mm beyond the tip";
  EXPECT_EQ(printed.LeastUp({-400'000, 100'000}, kLowest), kLowest);
}

TEST(PrintedHeights, HaveSquaresOnAllSidesOfTheOrigin) {
  for (const Point at : {Point{-1, -1}, Point{-1, 1}, Point{1, -1}, Point{-700'000'000, 3}}) {
    PrintedHeights printed(kTip);
    printed.Add(at, -10'000);
    EXPECT_EQ(printed.LeastUp(at, kLowest), -10'000);
    EXPECT_EQ(printed.LeastUp({at.x + 2'000'000, at.y}, kLowest), kLowest);
  }
}

// The tip's radius is 1.5 nozzles, and a layer is at most 0.75 nozzles high.
TEST(PrintedHeights, HaveSquaresThatGrowWithTheNozzle) {
  for (const Coord nozzle : {100'000, 400'000, 800'000, 1'200'000, 1'800'000, 5'000'000}) {
    PrintedHeights printed(nozzle + nozzle / 2);
    const Coord lowest = -nozzle * 3 / 4;
    printed.Add({nozzle, 0}, -10'000);
    EXPECT_EQ(printed.LeastUp({0, 0}, lowest), -10'000) << nozzle << " under the tip";
    EXPECT_EQ(printed.LeastUp({-2 * nozzle, 0}, lowest), lowest) << nozzle << " beyond the cone";
  }
}

// With squares of 0.2 mm, the area under this nozzle has more than 10,000 of them, each of which is
// looked up at each point.
TEST(PrintedHeights, WideNozzlesAreFast) {
  constexpr Coord kWide = 8'000'000;
  PrintedHeights printed(kWide);
  printed.Add({0, 0}, -10'000);
  int64_t held = 0;
  for (Coord x = -500'000; x < 500'000; ++x)
    held += printed.LeastUp({x, 0}, -kWide / 2) == -10'000 ? 1 : 0;
  EXPECT_EQ(held, 1'000'000);
}

}  // namespace
}  // namespace slicefarm::motion::printed_heights_test
