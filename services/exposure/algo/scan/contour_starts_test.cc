#include "services/exposure/algo/scan/contour_starts.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"

namespace slicefarm::exposure::contour_starts_test {
namespace {

const Polygon kSquare = {{0, 0}, {400, 0}, {400, 400}, {0, 400}};

TEST(StartedContour, BeginsWhereItIsTo) {
  struct Case {
    const char* name;
    ContourStart start;
    double share;
    Point at;
    Polyline line;
  };
  const Case kCases[] = {{"scattered: on an edge",
                          ContourStart::kScattered,
                          0.125,
                          {},
                          {{200, 0}, {400, 0}, {400, 400}, {0, 400}, {0, 0}, {200, 0}}},
                         {"scattered: at a corner",
                          ContourStart::kScattered,
                          0.5,
                          {},
                          {{400, 400}, {0, 400}, {0, 0}, {400, 0}, {400, 400}}},
                         {"nearest",
                          ContourStart::kNearest,
                          0.3,
                          {900, 10},
                          {{400, 0}, {400, 400}, {0, 400}, {0, 0}, {400, 0}}},
                         {"rear: the right one of two",
                          ContourStart::kRear,
                          0.3,
                          {},
                          {{400, 400}, {0, 400}, {0, 0}, {400, 0}, {400, 400}}}};
  for (const Case& c : kCases)
    EXPECT_EQ(StartedContour(kSquare, c.start, c.share, c.at), c.line) << c.name;
}

TEST(StartedContour, KeepsItsCourse) {
  std::mt19937 random(5);
  int lines = 0;
  for (int i = 0; i < 200; ++i)
    for (const PolygonWithHoles& island : RandomIsland(random, {}, 5))
      for (const ContourStart start :
           {ContourStart::kScattered, ContourStart::kNearest, ContourStart::kRear}) {
        const double share = static_cast<double>(random() % 1000) / 1000;
        const Polyline line = StartedContour(island.outer, start, share, {});
        ASSERT_FALSE(line.empty());
        ++lines;
        EXPECT_EQ(line.front(), line.back());
        EXPECT_GE(line.size(), island.outer.size() + 1);
        EXPECT_LE(line.size(), island.outer.size() + 2);
        const double area = SignedArea({line.begin(), line.end() - 1});
        EXPECT_NEAR(area, SignedArea(island.outer), 1e-6 * std::abs(area) + 1e9);
        EXPECT_NEAR(Length(line), Perimeter(island.outer), 2);
      }
  EXPECT_GE(lines, 3 * 200);
}

}  // namespace
}  // namespace slicefarm::exposure::contour_starts_test
