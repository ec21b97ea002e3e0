#include "services/ordering/algo/comb/curl_avoidance.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::ordering::curl_avoidance_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

/// Bar across a square of 40 mm, with 10 mm free above and below the bar.
constexpr const char* kBar = "(19.5 10, 20.5 10, 20.5 30, 19.5 30)";
constexpr const char* kWholeBar = "(19.5 -5, 20.5 -5, 20.5 45, 19.5 45)";
const Box kBounds{{0, 0}, {40 * kNmPerMm, 40 * kNmPerMm}};

struct Case {
  std::string name;
  Point from, to;
  std::vector<Point> corners;
  bool meets = false;
};

class CurlAvoidanceTest : public testing::TestWithParam<Case> {};

TEST_P(CurlAvoidanceTest, Meets) {
  const Case& c = GetParam();
  const CurlAvoidance paths(MakePolygonsOrDie(kBar), kBounds);
  EXPECT_EQ(paths.Meets(c.from, c.corners, c.to), c.meets);
  EXPECT_EQ(paths.Meets(c.to, std::vector<Point>(c.corners.rbegin(), c.corners.rend()), c.from),
            c.meets);
}

INSTANTIATE_TEST_SUITE_P(
    Routes, CurlAvoidanceTest,
    testing::Values(Case{"Across", Mm(10, 20), Mm(30, 20), {}, true},
                    Case{"Beside", Mm(10, 5), Mm(30, 5), {}},
                    Case{"Round", Mm(10, 20), Mm(30, 20), {Mm(20, 5)}},
                    Case{"RoundAndBack", Mm(10, 20), Mm(10, 21), {Mm(30, 20), Mm(30, 21)}, true},
                    Case{"BeginsOnIt", Mm(20, 20), Mm(30, 20), {}},
                    Case{"BeginsBehindIt", Mm(19.4, 20), Mm(30, 20), {}},
                    Case{"AlongIt", Mm(20, 12), Mm(20, 28), {}, true},
                    Case{"Short", Mm(19, 20), Mm(21, 20), {}},
                    Case{"Nowhere", Mm(20, 20), Mm(20, 20), {}}),
    [](const auto& info) { return info.param.name; });

TEST(CurlAvoidance, GoesRoundWithinTheRoom) {
  CurlAvoidance paths(MakePolygonsOrDie(kBar), kBounds);
  WorkBudget budget{10'000};
  const auto corners = paths.Around(Mm(10, 25), Mm(30, 25), budget);
  ASSERT_TRUE(corners);
  EXPECT_FALSE(corners->empty());
  EXPECT_FALSE(paths.Meets(Mm(10, 25), *corners, Mm(30, 25)));
  for (const Point corner : *corners) {
    EXPECT_GT(corner.y, FromMm(30));
    EXPECT_LT(corner.y, FromMm(31)) << "the shorter way, and the bar is not far";
  }
}

TEST(CurlAvoidance, NoWayIsNoWay) {
  CurlAvoidance paths(MakePolygonsOrDie(kWholeBar), kBounds);
  WorkBudget budget{10'000};
  EXPECT_TRUE(paths.Meets(Mm(10, 20), {}, Mm(30, 20)));
  EXPECT_FALSE(paths.Around(Mm(10, 20), Mm(30, 20), budget));
  CurlAvoidance round(MakePolygonsOrDie(kBar), kBounds);
  WorkBudget spent{0};
  EXPECT_FALSE(round.Around(Mm(10, 20), Mm(30, 20), spent));
}

TEST(CurlAvoidance, StaysWithinARegion) {
  const CurlAvoidance paths(MakePolygonsOrDie(kBar), kBounds);
  WorkBudget budget{10'000};
  const Point from = Mm(10, 25), to = Mm(30, 25);
  TravelPaths low = paths.PathsThrough(MakePolygonsOrDie("(5 5, 35 5, 35 28, 5 28)"));
  const auto corners = paths.Within(low, from, to, 1e12, budget);
  ASSERT_TRUE(corners);
  for (const Point corner : *corners) EXPECT_LT(corner.y, FromMm(10));
  EXPECT_FALSE(paths.Within(low, from, to, 30.0 * kNmPerMm, budget)) << "it is longer";
}

}  // namespace
}  // namespace slicefarm::ordering::curl_avoidance_test
