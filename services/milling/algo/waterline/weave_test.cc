#include "services/milling/algo/waterline/weave.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace slicefarm::milling::weave_test {
namespace {

using Gouged = std::function<bool(double, double)>;

/// Returns the intervals of a set on a line, found by steps and bisection.
std::vector<Interval> OnLine(const std::function<bool(double)>& in, double from, double to) {
  std::vector<Interval> found;
  const double step = 0.01;
  bool before = false;
  for (double x = from; x < to; x += step) {
    const bool now = in(x);
    if (now != before) {
      double low = x - step, high = x;
      for (int i = 0; i < 60; ++i) (in((low + high) / 2) == now ? high : low) = (low + high) / 2;
      if (now)
        found.push_back({high, 0, {}, {}});
      else
        found.back().high = low;
    }
    before = now;
  }
  return found;
}

std::vector<WovenLoop> Woven(const Gouged& in, double pitch) {
  const FiberGrid grid{-3, pitch, static_cast<int32_t>(6 / pitch) + 1};
  FiberIntervals rows, columns;
  for (int32_t i = 0; i < grid.count; ++i) {
    rows.push_back(OnLine([&](double x) { return in(x, grid.At(i)); }, -3, 3));
    columns.push_back(OnLine([&](double y) { return in(grid.At(i), y); }, -3, 3));
  }
  return WeaveLoops({grid, grid, rows, columns}, in);
}

double AreaOf(const WovenLoop& loop) {
  double sum = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Crossing &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

struct ShapeCase {
  const char* name;
  Gouged in;
  size_t outer, inner;
  double area;
};

TEST(WeaveLoops, FindsOuterAndInnerLoops) {
  const auto disc = [](double x, double y, double r) { return x * x + y * y < r * r; };
  for (const ShapeCase& c : {
           ShapeCase{"nothing", [](double, double) { return false; }, 0, 0, 0},
           ShapeCase{"disc", [=](double x, double y) { return disc(x, y, 1.7); }, 1, 0, 9.079},
           ShapeCase{"ring", [=](double x, double y) { return disc(x, y, 2) && !disc(x, y, 1); }, 1,
                     1, 9.425},
           ShapeCase{"two discs",
                     [=](double x, double y) { return disc(x - 1.2, y, 1) || disc(x + 1.2, y, 1); },
                     2, 0, 6.283},
           ShapeCase{
               "a bar on the diagonal, thin",
               [](double x, double y) { return std::abs(x - y) < 0.12 && std::abs(x + y) < 4; }, 1,
               0, 0.24 * 2 * 2},
           ShapeCase{"a square with a slit from the side",
                     [](double x, double y) {
                       return std::abs(x) < 2 && std::abs(y) < 2 &&
                              !(std::abs(x - 0.031) < 0.02 && y < 1);
                     },
                     1, 0, 16 - 0.12},
       }) {
    const auto loops = Woven(c.in, 0.11);
    size_t outer = 0;
    double area = 0;
    for (const WovenLoop& loop : loops) outer += AreaOf(loop) > 0 ? 1 : 0, area += AreaOf(loop);
    EXPECT_EQ(outer, c.outer) << c.name;
    EXPECT_EQ(loops.size() - outer, c.inner) << c.name;
    EXPECT_NEAR(area, c.area, 0.05 + 0.01 * c.area) << c.name;
  }
}

/// The set consists of random nodes, with all saddles that a grid can have. Every loop must close
/// with short steps, and no crossing may be in two loops.
TEST(WeaveLoops, ClosesWhateverTheCells) {
  std::mt19937 random(17);
  for (int round = 0; round < 200; ++round) {
    const FiberGrid grid{0, 1, 12};
    std::vector<std::vector<bool>> in(12, std::vector<bool>(12, false));
    for (int y = 1; y < 11; ++y)
      for (int x = 1; x < 11; ++x) in[y][x] = random() % 2 == 0;
    FiberIntervals rows(12), columns(12);
    for (int i = 0; i < 12; ++i) {
      for (int k = 1; k < 12; ++k) {
        if (in[i][k] && !in[i][k - 1]) rows[i].push_back({k - 0.4, 0, {}, {}});
        if (!in[i][k] && in[i][k - 1]) rows[i].back().high = k - 0.6;
        if (in[k][i] && !in[k - 1][i]) columns[i].push_back({k - 0.4, 0, {}, {}});
        if (!in[k][i] && in[k - 1][i]) columns[i].back().high = k - 0.6;
      }
    }
    const auto loops =
        WeaveLoops({grid, grid, rows, columns}, [&](double, double) { return random() % 2 == 0; });
    size_t crossings = 0, expected = 0;
    std::set<std::pair<double, double>> seen;
    for (const WovenLoop& loop : loops) {
      for (size_t i = 0; i < loop.size(); ++i) {
        const Crossing &a = loop[i], &b = loop[(i + 1) % loop.size()];
        EXPECT_LT(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1.01);
        EXPECT_TRUE(seen.insert({a.x, a.y}).second);
      }
      crossings += loop.size();
    }
    for (int i = 0; i < 12; ++i) expected += 2 * (rows[i].size() + columns[i].size());
    EXPECT_EQ(crossings, expected);
  }
}

/// The columns have other states of nodes on the contour, as rounding causes.
TEST(WeaveLoops, TakesTheRowsWordAboutNodes) {
  const FiberGrid grid{0, 1, 6};
  FiberIntervals rows(6), columns(6);
  rows[2] = rows[3] = {{2 - 1e-13, 3 + 1e-13, {}, {}}};
  columns[2] = {};  // the column only touches
  columns[3] = {{2 + 1e-13, 3.5, {}, {}}};
  const auto loops = WeaveLoops({grid, grid, rows, columns}, [](double, double) { return false; });
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_GT(AreaOf(loops[0]), 0.5);
}

}  // namespace
}  // namespace slicefarm::milling::weave_test
