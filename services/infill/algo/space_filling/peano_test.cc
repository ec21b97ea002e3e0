#include "services/infill/algo/space_filling/peano.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace slicefarm::infill::peano_test {
namespace {

std::vector<CurveCell> Curve(int order) {
  std::vector<CurveCell> cells;
  uint64_t count = 1;
  for (int i = 0; i < order; ++i) count *= 9;
  for (uint64_t i = 0; i < count; ++i) cells.push_back(PeanoCell(order, i));
  return cells;
}

int64_t Apart(uint32_t a, uint32_t b) {
  return std::abs(static_cast<int64_t>(a) - static_cast<int64_t>(b));
}

TEST(Peano, FirstOrder) {
  EXPECT_EQ(Curve(1), (std::vector<CurveCell>{
                          {0, 0}, {0, 1}, {0, 2}, {1, 2}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}));
}

TEST(Peano, CellsAreAllThereOnceAndNeighbours) {
  uint32_t side = 1;
  for (int order = 0; order <= 5; ++order, side *= 3) {
    const std::vector<CurveCell> cells = Curve(order);
    EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), uint64_t{side} * side);
    EXPECT_EQ(cells.front(), (CurveCell{0, 0}));
    EXPECT_EQ(cells.back(), (CurveCell{side - 1, side - 1}));
    for (size_t i = 0; i < cells.size(); ++i) {
      EXPECT_EQ(PeanoIndex(order, cells[i]), i);
      if (i == 0) continue;
      EXPECT_EQ(Apart(cells[i].x, cells[i - 1].x) + Apart(cells[i].y, cells[i - 1].y), 1);
    }
  }
}

TEST(Peano, RoundTripAtTheHighestOrder) {
  uint64_t count = 1;
  for (int i = 0; i < 20; ++i) count *= 9;
  for (const uint64_t index : {uint64_t{0}, uint64_t{1}, count / 2, count / 7 * 3, count - 1})
    EXPECT_EQ(PeanoIndex(20, PeanoCell(20, index)), index);
}

// The curve is less local than Hilbert's, and has three times as many steps in one direction: it is
// not isotropic.
TEST(Peano, Locality) {
  for (const auto& [order, want] : {std::pair{2, 5.0}, std::pair{3, 7.0487805}}) {
    const std::vector<CurveCell> cells = Curve(order);
    double worst = 0;
    for (size_t i = 0; i < cells.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        const auto dx = static_cast<double>(Apart(cells[i].x, cells[j].x));
        const auto dy = static_cast<double>(Apart(cells[i].y, cells[j].y));
        worst = std::max(worst, (dx * dx + dy * dy) / static_cast<double>(i - j));
      }
    }
    EXPECT_NEAR(worst, want, 1e-6);
  }
}

TEST(Peano, StepsRunThreeToOneUpwards) {
  const int upwards[] = {6, 60, 546}, across[] = {2, 20, 182};
  for (int order = 1; order <= 3; ++order) {
    const std::vector<CurveCell> cells = Curve(order);
    int up = 0;
    for (size_t i = 1; i < cells.size(); ++i) up += cells[i].x == cells[i - 1].x ? 1 : 0;
    EXPECT_EQ(up, upwards[order - 1]);
    EXPECT_EQ(static_cast<int>(cells.size()) - 1 - up, across[order - 1]);
  }
}

TEST(Peano, NeighboursOnTheGridAreNearOnTheCurve) {
  double sum = 0;
  int64_t worst = 0, count = 0;
  const auto add = [&](CurveCell a, CurveCell b) {
    const int64_t apart =
        std::abs(static_cast<int64_t>(PeanoIndex(2, a)) - static_cast<int64_t>(PeanoIndex(2, b)));
    sum += static_cast<double>(apart), worst = std::max(worst, apart), ++count;
  };
  for (uint32_t x = 0; x < 9; ++x)
    for (uint32_t y = 0; y + 1 < 9; ++y) add({x, y}, {x, y + 1}), add({y, x}, {y + 1, x});
  EXPECT_NEAR(sum / static_cast<double>(count), 5.6666667, 1e-6);
  EXPECT_EQ(worst, 41);
}

}  // namespace
}  // namespace slicefarm::infill::peano_test
