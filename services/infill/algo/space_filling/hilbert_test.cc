#include "services/infill/algo/space_filling/hilbert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace slicefarm::infill::hilbert_test {
namespace {

std::vector<CurveCell> Curve(int order) {
  std::vector<CurveCell> cells;
  for (uint64_t i = 0; i < uint64_t{1} << (2 * order); ++i) cells.push_back(HilbertCell(order, i));
  return cells;
}

int64_t Apart(uint32_t a, uint32_t b) {
  return std::abs(static_cast<int64_t>(a) - static_cast<int64_t>(b));
}

TEST(Hilbert, SecondOrder) {
  EXPECT_EQ(Curve(2), (std::vector<CurveCell>{{0, 0},
                                              {1, 0},
                                              {1, 1},
                                              {0, 1},
                                              {0, 2},
                                              {0, 3},
                                              {1, 3},
                                              {1, 2},
                                              {2, 2},
                                              {2, 3},
                                              {3, 3},
                                              {3, 2},
                                              {3, 1},
                                              {2, 1},
                                              {2, 0},
                                              {3, 0}}));
}

// One direction uses the table, the other uses Gray code: the two are independent of each other.
TEST(Hilbert, CellsAreAllThereOnceAndNeighbours) {
  for (int order = 0; order <= 7; ++order) {
    const std::vector<CurveCell> cells = Curve(order);
    EXPECT_EQ(std::set(cells.begin(), cells.end()).size(), cells.size());
    EXPECT_EQ(cells.front(), (CurveCell{0, 0}));
    EXPECT_EQ(cells.back(), (CurveCell{(uint32_t{1} << order) - 1, 0}));
    for (size_t i = 0; i < cells.size(); ++i) {
      EXPECT_EQ(HilbertIndex(order, cells[i]), i);
      if (i == 0) continue;
      EXPECT_EQ(Apart(cells[i].x, cells[i - 1].x) + Apart(cells[i].y, cells[i - 1].y), 1);
    }
  }
}

TEST(Hilbert, RoundTripAtTheHighestOrder) {
  for (const uint64_t index :
       {uint64_t{0}, uint64_t{1} << 61, (uint64_t{1} << 62) - 1, uint64_t{0x123456789abcdef0}}) {
    EXPECT_EQ(HilbertIndex(31, HilbertCell(31, index)), index);
  }
}

/// Returns the curve by the rules A -> +BF-AFA-FB+, B -> -AF+BFB+FA-; + turns left.
std::string Grown(char symbol, int depth) {
  if (depth == 0) return "";
  std::string grown;
  for (const char c : std::string(symbol == 'A' ? "+BF-AFA-FB+" : "-AF+BFB+FA-"))
    grown += c == 'A' || c == 'B' ? Grown(c, depth - 1) : std::string(1, c);
  return grown;
}

TEST(Hilbert, IsTheLSystemsCurve) {
  for (int order = 1; order <= 4; ++order) {
    std::vector<CurveCell> drawn = {{0, 0}};
    int x = 0, y = 0, dx = 1, dy = 0;
    for (const char c : Grown('A', order)) {
      if (c == '+') std::tie(dx, dy) = std::pair(-dy, dx);
      if (c == '-') std::tie(dx, dy) = std::pair(dy, -dx);
      if (c != 'F') continue;
      x += dx, y += dy;
      drawn.push_back({static_cast<uint32_t>(x), static_cast<uint32_t>(y)});
    }
    EXPECT_EQ(drawn, Curve(order)) << order;
  }
}

/// Returns the largest ratio of the squared distance of two cells to their distance along the
/// curve.
double WorstLocality(const std::vector<CurveCell>& cells) {
  double worst = 0;
  for (size_t i = 0; i < cells.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const auto dx = static_cast<double>(Apart(cells[i].x, cells[j].x));
      const auto dy = static_cast<double>(Apart(cells[i].y, cells[j].y));
      worst = std::max(worst, (dx * dx + dy * dy) / static_cast<double>(i - j));
    }
  }
  return worst;
}

TEST(Hilbert, LocalityStaysBelowSix) {
  const double worst[] = {3.625, 4.4814815, 5.2325581, 5.6198830};
  for (int order = 3; order <= 6; ++order)
    EXPECT_NEAR(WorstLocality(Curve(order)), worst[order - 3], 1e-6);
}

TEST(Hilbert, NeighboursOnTheGridAreNearOnTheCurve) {
  for (const auto& [order, mean, most] :
       {std::tuple{3, 5.0714286, 53}, std::tuple{4, 9.9166667, 213}}) {
    const uint32_t side = uint32_t{1} << order;
    double sum = 0;
    int64_t worst = 0, count = 0;
    const auto add = [&, order = order](CurveCell a, CurveCell b) {
      const int64_t apart = std::abs(static_cast<int64_t>(HilbertIndex(order, a)) -
                                     static_cast<int64_t>(HilbertIndex(order, b)));
      sum += static_cast<double>(apart), worst = std::max(worst, apart), ++count;
    };
    for (uint32_t x = 0; x < side; ++x)
      for (uint32_t y = 0; y + 1 < side; ++y) add({x, y}, {x, y + 1}), add({y, x}, {y + 1, x});
    EXPECT_NEAR(sum / static_cast<double>(count), mean, 1e-6);
    EXPECT_EQ(worst, most);
  }
}

TEST(Hilbert, RunsBothWaysEqually) {
  const std::vector<CurveCell> cells = Curve(5);
  int across = 0;
  for (size_t i = 1; i < cells.size(); ++i) across += cells[i].y == cells[i - 1].y ? 1 : 0;
  EXPECT_EQ(std::min(across, 1023 - across), 511);
}

}  // namespace
}  // namespace slicefarm::infill::hilbert_test
