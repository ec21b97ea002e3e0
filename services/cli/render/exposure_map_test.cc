#include "services/cli/render/exposure_map.h"

#include <gtest/gtest.h>

namespace slicefarm::cli::exposure_map_test {
namespace {

BeadRun Line(Vector2 from, Vector2 to, double width_mm = 1) {
  BeadRun run;
  run.feature = "hatch";
  run.width_mm = width_mm;
  run.points = {from, to};
  return run;
}

double At(const ExposureMap& map, const Layout& layout, Vector2 p) {
  const Vector2 pixel = layout.ToPixel(p);
  return map.values.at(static_cast<size_t>(pixel.y()) * static_cast<size_t>(layout.part_width_px) +
                       static_cast<size_t>(pixel.x()));
}

// Lines of 1 mm that cross: one pass along each, two at the crossing, none beside.
TEST(MapExposure, CountsPasses) {
  GcodeLayer layer;
  layer.beads = {Line({0, 10}, {20, 10}), Line({10, 0}, {10, 20})};
  const Layout layout = LayOut(layer, {});
  const ExposureMap map = MapExposure(layer, layout);
  EXPECT_DOUBLE_EQ(At(map, layout, {3, 10}), 1);
  EXPECT_DOUBLE_EQ(At(map, layout, {10, 3}), 1);
  EXPECT_DOUBLE_EQ(At(map, layout, {10, 10}), 2);
  EXPECT_DOUBLE_EQ(At(map, layout, {3, 3}), 0);
  EXPECT_EQ(map.unit, "passes");
}

// Two lines of different energies. Each adds its own energy over its width, and both add up at the
// crossing.
TEST(MapExposure, InJoulesWhereTheyAreKnown) {
  GcodeLayer layer;
  layer.beads = {Line({0, 10}, {20, 10}, 2), Line({10, 0}, {10, 20}, 2)};
  layer.beads[0].energy_j_mm = 0.5;
  layer.beads[1].energy_j_mm = 0.2;
  const Layout layout = LayOut(layer, {});
  const ExposureMap map = MapExposure(layer, layout);
  EXPECT_EQ(map.unit, "J/mm2");
  EXPECT_DOUBLE_EQ(At(map, layout, {3, 10}), 0.25);
  EXPECT_DOUBLE_EQ(At(map, layout, {10, 3}), 0.1);
  EXPECT_DOUBLE_EQ(At(map, layout, {10, 10}), 0.35);
  EXPECT_DOUBLE_EQ(map.Most(), 0.35);
  // The energy of one line is not known, so passes are counted for both.
  layer.beads[1].energy_j_mm = 0;
  EXPECT_EQ(MapExposure(layer, layout).unit, "passes");
}

// The sum over all pixels is length times width.
TEST(MapExposure, SumsUpToTheAreaOfAllPasses) {
  GcodeLayer layer;
  for (int i = 0; i < 5; ++i) layer.beads.push_back(Line({0, i * 1.0}, {30, i * 1.0}, 1.5));
  const Layout layout = LayOut(layer, {});
  double sum = 0;
  for (const double passes : MapExposure(layer, layout).values) sum += passes;
  EXPECT_NEAR(sum / (layout.px_per_mm * layout.px_per_mm) / (5 * 30 * 1.5), 1, 0.01);
}

TEST(MapExposure, StopsCountingAtItsMost) {
  GcodeLayer layer;
  for (int i = 0; i < 40; ++i) layer.beads.push_back(Line({0, 0}, {20, 0}));
  const Layout layout = LayOut(layer, {});
  EXPECT_DOUBLE_EQ(At(MapExposure(layer, layout), layout, {10, 0}), kMostPasses);
}

}  // namespace
}  // namespace slicefarm::cli::exposure_map_test
