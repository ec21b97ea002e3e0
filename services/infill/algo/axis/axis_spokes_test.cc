#include "services/infill/algo/axis/axis_spokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/axis/main_axis.h"

namespace slicefarm::infill::axis_spokes_test {
namespace {

PolygonWithHoles P(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

Polygon Ngon(double radius_mm, int corners) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    ring.push_back({FromMm(radius_mm * Cos(turn)), FromMm(radius_mm * Sin(turn))});
  }
  return ring;
}

PolygonWithHoles Ring(double outer_mm, double inner_mm) {
  Polygon hole = Ngon(inner_mm, 60);
  std::ranges::reverse(hole);
  return {Ngon(outer_mm, 90), {hole}};
}

struct SpokeCase {
  std::string name;
  PolygonWithHoles island;
  size_t spokes;
};

// There is one spoke for each ring that the axis does not reach, from the ring to the axis.
TEST(AxisSpokes, ReachTheRingsThatTheAxisDoesNot) {
  const SpokeCase cases[] = {
      {"strip", P("(0 0, 60 0, 60 10, 0 10)"), 0},
      {"disc", {Ngon(20, 90), {}}, 1},
      {"ring", Ring(20, 15), 2},
      {"plate with a hole", P("(0 0, 60 0, 60 40, 0 40) (20 15, 20 25, 40 25, 40 15)"), 1}};
  for (const SpokeCase& c : cases) {
    const std::vector<Polyline> axis = MainAxis(c.island, {});
    const std::vector<Polyline> spokes = AxisSpokes(c.island, axis);
    ASSERT_EQ(spokes.size(), c.spokes) << c.name;
    for (const Polyline& spoke : spokes) {
      ASSERT_EQ(spoke.size(), 2u) << c.name;
      EXPECT_EQ(Locate(spoke[0], c.island), Side::kBoundary) << c.name;
      EXPECT_EQ(Locate(spoke[1], c.island), Side::kInside) << c.name;
    }
  }
}

}  // namespace
}  // namespace slicefarm::infill::axis_spokes_test
