#include "services/exposure/algo/scan/hatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/scan/coverage_test.h"

namespace slicefarm::exposure::hatch_test {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

std::vector<Point> HatchOrDie(const MultiPolygon& region, double angle_deg,
                              const ExposureOptions& options) {
  auto points = Hatch({region}, angle_deg, options, {});
  EXPECT_TRUE(points.ok()) << points.status();
  return points.ok() ? *std::move(points) : std::vector<Point>{};
}

ExposureOptions With(ScanStrategy strategy) {
  ExposureOptions options;
  options.strategy = strategy;
  options.stripe_width_nm = 2'000'000;
  options.island_width_nm = 1'500'000;
  return options;
}

double LengthMm(const std::vector<Point>& points) {
  double length = 0;
  for (size_t i = 0; i + 1 < points.size(); i += 2) length += Distance(points[i], points[i + 1]);
  return length / kNmPerMm;
}

double JumpMm(const std::vector<Point>& points) {
  double length = 0;
  for (size_t i = 1; i + 1 < points.size(); i += 2) length += Distance(points[i], points[i + 1]);
  return length / kNmPerMm;
}

const ScanStrategy kStrategies[] = {ScanStrategy::kHatch, ScanStrategy::kStripes,
                                    ScanStrategy::kIslands};

/// Lines are at whole multiples of the distance (in odd stripes half multiples), to less than 2 nm.
TEST(Hatch, DistancesAreExact) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 17 1, 15 12, 3 14) (5 5, 6 9, 9 8)");
  for (const ScanStrategy strategy : kStrategies) {
    for (const double angle : {0.0, 30.0, 90.0, 112.5, 293.0}) {
      const ExposureOptions options = With(strategy);
      const double pitch = static_cast<double>(options.hatch_distance_nm);
      const std::vector<Point> points = HatchOrDie(region, angle, options);
      ASSERT_FALSE(points.empty());
      for (const Point p : points) {
        const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
        const double v = std::cos(angle * kRadians) * y - std::sin(angle * kRadians) * x;
        const double u = std::cos(angle * kRadians) * x + std::sin(angle * kRadians) * y;
        const auto off = [&](double at, double unit) {
          return std::abs(at - unit * std::round(at / unit));
        };
        const double unit = strategy == ScanStrategy::kStripes ? pitch / 2 : pitch;
        const double least = strategy == ScanStrategy::kIslands
                                 ? std::min(off(v, unit), off(u, unit))
                                 : off(v, unit);
        EXPECT_LT(least, 2.0);
      }
    }
  }
}

TEST(Hatch, LinesOfAHatchAreNeighboursAtTheDistance) {
  const auto points =
      HatchOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), 0, With(ScanStrategy::kHatch));
  ASSERT_EQ(points.size() / 2, 125u);  // lines from 0 to 9.92
  for (size_t i = 0; i + 2 < points.size(); i += 2) {
    EXPECT_EQ(points[i + 2].y - points[i].y, 80'000);
    EXPECT_EQ(points[i].y, points[i + 1].y);
    EXPECT_EQ(std::abs(points[i + 1].x - points[i].x), 10'000'000);
    EXPECT_EQ(points[i + 1].x, points[i + 2].x);  // to and fro
  }
}

TEST(Hatch, StaysInsideAndCoversTheRegionOnce) {
  std::mt19937 random(6);
  for (int i = 0; i < 40; ++i) {
    const MultiPolygon region = RandomIsland(random, {i * 1'234'567, -i * 7'654'321}, 5);
    for (const ScanStrategy strategy : kStrategies) {
      ExposureOptions options = With(strategy);
      options.overlap_nm = 0;
      const auto points = HatchOrDie(region, Uniform(random, 0, 360), options);
      for (const Point p : points) {
        if (Inside(p, region)) continue;
        EXPECT_LE(DistanceToBoundary(p, region), 2.0);
      }
      // Each line represents a strip: the total area of the strips is the region's area.
      const double area = Area(region) / 1e12;
      EXPECT_NEAR(LengthMm(points) * 0.08, area, 0.03 * area + 0.15);
    }
  }
}

TEST(Hatch, OverlapsAreWhatWasAskedFor) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 12 0, 12 12, 0 12)");
  ExposureOptions options = With(ScanStrategy::kStripes);
  options.overlap_nm = 0;
  const double none = LengthMm(HatchOrDie(square, 0, options));
  options.overlap_nm = 100'000;
  // 6 stripes have 5 borders. At each border, 150 lines are longer by half the overlap on both
  // sides.
  EXPECT_NEAR(LengthMm(HatchOrDie(square, 0, options)) - none, 5 * 150 * 0.1, 0.3);
}

TEST(Hatch, IslandsTurnByARightAngle) {
  ExposureOptions options = With(ScanStrategy::kIslands);
  options.overlap_nm = 0;
  const auto points = HatchOrDie(MakePolygonsOrDie("(0 0, 6 0, 6 6, 0 6)"), 0, options);
  for (size_t i = 0; i + 1 < points.size(); i += 2) {
    const Point a = points[i], b = points[i + 1];
    const Coord column = (a.x + b.x) / 2 / 1'500'000, row = (a.y + b.y) / 2 / 1'500'000;
    // A line on a border belongs to one side of it.
    if ((a.x == b.x && a.x % 1'500'000 == 0) || (a.y == b.y && a.y % 1'500'000 == 0)) continue;
    EXPECT_EQ((column + row) % 2 == 0, a.y == b.y) << column << " " << row;
    EXPECT_LE(Distance(a, b), 1'500'001);
  }
}

TEST(Hatch, ShortVectorsAreLeftOut) {
  ExposureOptions options = With(ScanStrategy::kHatch);
  options.minimum_vector_nm = 1'000'000;
  const auto points = HatchOrDie(MakePolygonsOrDie("(0 0, 10 0, 5 9)"), 0, options);
  ASSERT_FALSE(points.empty());
  for (size_t i = 0; i + 1 < points.size(); i += 2)
    EXPECT_GE(Distance(points[i], points[i + 1]), 1'000'000 - 2);
}

TEST(Hatch, OneDirectionIfAskedFor) {
  ExposureOptions options = With(ScanStrategy::kHatch);
  options.alternate_directions = false;
  const auto points =
      HatchOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10) (3 3, 7 3, 7 7, 3 7)"), 0, options);
  for (size_t i = 0; i + 1 < points.size(); i += 2) EXPECT_LT(points[i].x, points[i + 1].x);
}

TEST(Hatch, JumpsFollowTheOrderAskedFor) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  ExposureOptions options = With(ScanStrategy::kIslands);
  std::map<JumpOrder, double> jumps;
  for (const JumpOrder order :
       {JumpOrder::kNearest, JumpOrder::kChequerboard, JumpOrder::kFarthest}) {
    options.jump_order = order;
    const auto points = HatchOrDie(square, 45, options);
    jumps[order] = JumpMm(points);
    options.jump_order = JumpOrder::kNearest;
    EXPECT_NEAR(LengthMm(points), LengthMm(HatchOrDie(square, 45, options)), 1e-3);
  }
  EXPECT_LT(jumps[JumpOrder::kNearest], jumps[JumpOrder::kChequerboard]);
  EXPECT_LT(jumps[JumpOrder::kChequerboard], jumps[JumpOrder::kFarthest]);
}

TEST(Hatch, NeighbouringRegionsContinueEachOther) {
  // Cutting a region in two changes no line except that the line is cut.
  ExposureOptions options = With(ScanStrategy::kHatch);
  const double whole =
      LengthMm(HatchOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), 33, options));
  const double halves =
      LengthMm(HatchOrDie(MakePolygonsOrDie("(0 0, 5 0, 5 10, 0 10)"), 33, options)) +
      LengthMm(HatchOrDie(MakePolygonsOrDie("(5 0, 10 0, 10 10, 5 10)"), 33, options));
  EXPECT_NEAR(whole, halves, 1e-3);
}

TEST(Hatch, OfNothingIsNothing) {
  for (const ScanStrategy strategy : kStrategies)
    EXPECT_TRUE(HatchOrDie({}, 0, With(strategy)).empty());
}

}  // namespace
}  // namespace slicefarm::exposure::hatch_test
