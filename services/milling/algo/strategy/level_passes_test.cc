#include "services/milling/algo/strategy/level_passes.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "services/milling/algo/sample_jobs_test.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling::level_passes_test {
namespace {

Polygon Square(double low, double high) {
  return {PointOf({low, low}), PointOf({high, low}), PointOf({high, high}), PointOf({low, high})};
}

Polygon Hole(double low, double high) {
  const Polygon ring = Square(low, high);
  return {ring.rbegin(), ring.rend()};
}

double LeastDistance(const std::vector<Polygon>& passes, Point p) {
  double least = 1e18;
  for (const Polygon& pass : passes)
    for (size_t i = 0; i < pass.size(); ++i)
      least = std::min(least, DistanceToSegment(p, pass[i], pass[(i + 1) % pass.size()]));
  return least;
}

/// Checks that every point of an area is at most a stepover from a pass.
void ExpectCovered(const std::vector<CutArea>& areas, double stepover, const char* what) {
  for (const CutArea& area : areas) {
    for (double x = -2; x < 22; x += 0.37) {
      for (double y = -2; y < 22; y += 0.41) {
        const Point p = PointOf({x, y});
        if (Locate(p, area.area) != Side::kInside) continue;
        EXPECT_LT(LeastDistance(area.passes, p), FromMm(stepover) * 1.01) << what << x << " " << y;
      }
    }
  }
}

struct RingCase {
  const char* name;
  FreeArea level;
  bool from_outside;
};

TEST(RoughingPasses, CoverTheAreaInTheOrderOfCutting) {
  const MultiPolygon stock = {{.outer = Square(0, 20), .holes = {}}};
  for (const RingCase& c : {
           RingCase{"face", {stock, stock}, true},
           RingCase{"around an island", {stock, {{Square(0, 20), {Hole(8, 14)}}}}, true},
           RingCase{"pocket", {stock, {{Square(4, 17), {}}}}, false},
           RingCase{"pocket with an island", {stock, {{Square(2, 18), {Hole(9, 11)}}}}, false},
       }) {
    const MillingOptions options = OptionsFor("cyl:4");
    const std::vector<CutArea> areas = RoughingPasses(c.level, options);
    ASSERT_EQ(areas.size(), 1u) << c.name;
    ExpectCovered(areas, options.stepover_mm(), c.name);
    const std::vector<Polygon>& passes = areas[0].passes;
    const double first = std::abs(SignedArea(passes.front())),
                 last = std::abs(SignedArea(passes.back()));
    EXPECT_EQ(first > last, c.from_outside) << c.name;
    if (!c.from_outside && !c.level.free[0].holes.empty()) continue;  // begins at the island
    // Climb milling has the stock on the right. Going inwards, the stock is inside of the pass;
    // going outwards, it is outside.
    EXPECT_EQ(SignedArea(passes.front()) < 0, c.from_outside) << c.name;
    MillingOptions turned = options;
    turned.machining.direction = CutDirection::kConventional;
    EXPECT_EQ(SignedArea(RoughingPasses(c.level, turned)[0].passes.front()) > 0, c.from_outside)
        << c.name;
  }
}

TEST(RoughingPasses, LeaveOutWhatIsTooNarrow) {
  const MultiPolygon free = {
      {Square(0, 10), {}},
      {{PointOf({12, 0}), PointOf({12.3, 0}), PointOf({12.3, 9}), PointOf({12, 9})}, {}}};
  MillingOptions options = OptionsFor("cyl:4");
  options.minimum_width_mm = 0.2;
  EXPECT_EQ(RoughingPasses({free, free}, options).size(), 2u);
  options.minimum_width_mm = 0.4;
  EXPECT_EQ(RoughingPasses({free, free}, options).size(), 1u);
}

TEST(FinishingPasses, AreTheOutlinesWithTheStockOnTheRight) {
  const MultiPolygon stock = {{.outer = Square(0, 20), .holes = {}}};
  const FreeArea level{stock, {{Square(0, 20), {Hole(8, 14), Hole(2, 5)}}}};
  const std::vector<CutArea> areas = FinishingPasses(level, OptionsFor("ball:2"));
  ASSERT_EQ(areas.size(), 1u);
  ASSERT_EQ(areas[0].passes.size(), 3u);
  EXPECT_LT(SignedArea(areas[0].passes[0]), 0);
  EXPECT_GT(SignedArea(areas[0].passes[2]), 0);
}

}  // namespace
}  // namespace slicefarm::milling::level_passes_test
