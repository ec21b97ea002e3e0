#include "services/motion/algo/toolpath/footprint.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"

namespace slicefarm::motion::footprint_test {
namespace {

Move MoveTo(int32_t x_um, int32_t y_um, MoveKind kind, int32_t width_um = 400) {
  Move move;
  move.x_um = x_um;
  move.y_um = y_um;
  move.kind = kind;
  move.width_um = width_um;
  return move;
}

/// Returns a travel to (10, 10) mm, a bead to (20, 10) mm, and a travel far away.
Toolpath Bead(int32_t width_um) {
  Toolpath path;
  path.moves = {MoveTo(10'000, 10'000, MoveKind::kTravel),
                MoveTo(20'000, 10'000, MoveKind::kPrint, width_um),
                MoveTo(90'000, 90'000, MoveKind::kTravel)};
  return path;
}

Box BoxMm(double x0, double y0, double x1, double y1) {
  return {{FromMm(x0), FromMm(y0)}, {FromMm(x1), FromMm(y1)}};
}

TEST(FootprintOf, BeadsWithTheirEdgesInTheirPlaces) {
  const Toolpath path = Bead(400);
  const std::vector<MoveSpan> once = {{&path, 0, 3, {}}};
  EXPECT_EQ(Bounds(FootprintOf(once)), BoxMm(9.8, 9.8, 20.2, 10.2));
  const std::vector<MoveSpan> twice = {{&path, 0, 3, {}}, {&path, 0, 3, {5'000, 50'000}}};
  EXPECT_EQ(Bounds(FootprintOf(twice)), BoxMm(9.8, 9.8, 25.2, 60.2));
}

TEST(FootprintOf, NothingIsPrinted) {
  Toolpath path = Bead(400);
  path.moves[1].kind = MoveKind::kTravel;
  const std::vector<MoveSpan> program = {{&path, 0, 3, {}}};
  EXPECT_TRUE(FootprintOf(program).empty());
}

TEST(FirstLayerHull, HoldsAllPasses) {
  ProgramSummary summary;
  summary.layers.resize(3);
  summary.layers[0].footprint = {{0, 0}, {10, 0}, {0, 10}};
  summary.layers[2].footprint = {{100, 0}, {110, 0}, {100, 10}};
  EXPECT_EQ(Bounds(FirstLayerHull(summary)), (Box{{0, 0}, {110, 10}}));
}

}  // namespace
}  // namespace slicefarm::motion::footprint_test
