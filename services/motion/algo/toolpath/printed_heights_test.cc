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

}  // namespace
}  // namespace slicefarm::motion::printed_heights_test
