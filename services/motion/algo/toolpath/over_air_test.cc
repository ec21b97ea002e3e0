#include <gtest/gtest.h>

#include <algorithm>

#include "common/model/options/motion_options.h"
#include "common/model/paths_test.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion::over_air_test {
namespace {

LayerBelow Square(double from_mm, double to_mm) {
  return LayerBelow({{{{FromMm(from_mm), FromMm(-5)},
                       {FromMm(to_mm), FromMm(-5)},
                       {FromMm(to_mm), FromMm(5)},
                       {FromMm(from_mm), FromMm(5)}},
                      {}}});
}

/// Returns the feed rate of a wall from x = 1 to 30 mm at each move's end.
std::vector<std::pair<double, int32_t>> Rates(const MotionOptions& options, const LayerBelow& below,
                                              const LayerBelow* curled) {
  ToolpathBuilder builder(options, {3, 800'000, 200'000}, 200'000, Ground::kLayers, &below, nullptr,
                          curled);
  Path wall = MakePathOrDie("(1 0, 30 0)");
  wall.feature = Feature::kPerimeter;
  wall.widths_nm = {450'000};
  builder.Add(wall);
  std::vector<std::pair<double, int32_t>> rates;
  for (const Move& move : builder.Finish().moves)
    if (move.kind == MoveKind::kPrint) rates.emplace_back(move.x_um / 1000.0, move.feed_rate);
  return rates;
}

TEST(OverAir, WallsAboveCurledEdgesAreSlower) {
  MotionOptions options;
  options.speeds[0].small_perimeter_radius_mm = 0;
  options.speeds[0].dynamic_overhangs = true;
  options.speeds[0].overhang_speed_mm_s = {5, 10, 20, 25};
  const LayerBelow below = Square(-5, 40), curled = Square(10, 20);
  ASSERT_FALSE(Rates(options, below, nullptr).empty());
  for (const auto& [x_mm, rate] : Rates(options, below, nullptr)) EXPECT_EQ(rate, 60 * 60) << x_mm;
  // The wall is slow from where it reaches the curled edges to where it leaves them, in steps of a
  // millimetre.
  double slow_from = 40, slow_to = 0, before = 1;
  for (const auto& [x_mm, rate] : Rates(options, below, &curled)) {
    if (rate != 60 * 60) {
      EXPECT_EQ(rate, 20 * 60) << x_mm;
      slow_from = std::min(slow_from, before);
      slow_to = x_mm;
    }
    before = x_mm;
  }
  EXPECT_NEAR(slow_from, 9.5, 0.6);
  EXPECT_NEAR(slow_to, 20.5, 0.6);
  const LayerBelow air = Square(-5, 0);
  for (const auto& [x_mm, rate] : Rates(options, air, &curled)) EXPECT_LE(rate, 5 * 60) << x_mm;
}

}  // namespace
}  // namespace slicefarm::motion::over_air_test
