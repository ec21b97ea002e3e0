#include "services/infill/algo/fields/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::surface_distance_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns layers of 0.5 mm of object 3, from bottom to top.
std::vector<SlicedLayer> LayersOf(const std::vector<MultiPolygon>& outlines) {
  std::vector<SlicedLayer> layers;
  for (int i = 0; i < static_cast<int>(outlines.size()); ++i) {
    SlicedLayer& layer = layers.emplace_back();
    ObjectSection section{3,
                          i,
                          static_cast<int32_t>(outlines.size()),
                          500'000,
                          {{Role::kPart, 0, 0, outlines[static_cast<size_t>(i)]}},
                          {},
                          0,
                          {}};
    section.z_nm = 500'000 * (i + 1);
    layer.sections.push_back(section);
  }
  return layers;
}

TEST(SurfaceDistances, OfABoxAreThoseOfItsNearestFace) {
  const auto layers = LayersOf(std::vector<MultiPolygon>(40, P("(0 0, 30 0, 30 20, 0 20)")));
  SurfaceDistances distances(layers, 3, 8);
  for (const int layer : {0, 5, 20, 39}) {
    const DistanceMap map = *distances.Of(layer);
    const double z = 0.5 * layer + 0.25;
    for (double x = 0.3; x < 30; x += 1.7) {
      for (double y = 0.3; y < 20; y += 1.3) {
        const double true_mm = std::min({x, 30 - x, y, 20 - y, z, 20 - z, 8.0});
        EXPECT_NEAR(map.At(x, y), true_mm, 0.26) << x << ", " << y << ", " << z;
      }
    }
  }
}

TEST(SurfaceDistances, LookPastEdgesOfOtherLayers) {
  // A step: the upper half of the layers is only 10 mm wide.
  std::vector<MultiPolygon> outlines(20, P("(0 0, 30 0, 30 20, 0 20)"));
  std::fill(outlines.begin() + 10, outlines.end(), P("(0 0, 10 0, 10 20, 0 20)"));
  const auto layers = LayersOf(outlines);
  SurfaceDistances distances(layers, 3, 6);
  const DistanceMap map = *distances.Of(7);  // height 3.75; the step is at 5
  EXPECT_NEAR(map.At(20, 10), 1.25, 0.1);
  EXPECT_NEAR(map.At(7, 10), 3.25, 0.3) << "the edge of the step, over 3 and up 1.25";
}

TEST(SurfaceDistances, DoNotDependOnLayersBeyondTheirReach) {
  const auto layers =
      LayersOf({P("(0 0, 9 0, 9 9, 0 9)"), P("(0 0, 12 0, 12 9, 0 9)"), P("(0 0, 9 0, 9 14, 0 14)"),
                P("(0 0, 9 0, 9 9, 0 9)"), P("(0 0, 50 0, 50 9, 0 9)"), P("(0 0, 9 0, 9 9, 0 9)"),
                P("(-20 0, 9 0, 9 9, 0 9)"), P("(0 0, 9 0, 9 9, 0 9)")});
  SurfaceDistances all(layers, 3, 1),
      some(std::span<const SlicedLayer>(layers).subspan(1, 5), 3, 1);
  const DistanceMap a = *all.Of(3), b = *some.Of(3);
  for (double x = 0; x < 9; x += 0.4)
    for (double y = 0; y < 9; y += 0.4) EXPECT_EQ(a.At(x, y), b.At(x, y)) << x << ", " << y;
}

TEST(SurfaceDistances, HolesAreSurfaceToo) {
  const auto layers = LayersOf(
      std::vector<MultiPolygon>(20, P("(0 0, 30 0, 30 30, 0 30)(10 10, 10 20, 20 20, 20 10)")));
  SurfaceDistances distances(layers, 3, 4);
  const DistanceMap map = *distances.Of(10);
  EXPECT_NEAR(map.At(8, 15), 2, 0.26);
  EXPECT_NEAR(map.At(15, 15), 0, 0.26);
}

TEST(SurfaceDistances, RefuseObjectsOfTooManyCells) {
  const auto layers = LayersOf({P("(0 0, 900 0, 900 900, 0 900)")});
  SurfaceDistances distances(layers, 3, 1);
  EXPECT_TRUE(distances.Has(0));
  EXPECT_FALSE(distances.Has(1));
  EXPECT_EQ(DetailOf(distances.Of(0).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::surface_distance_test
