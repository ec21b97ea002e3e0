#include "services/motion/algo/toolpath/flow_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::motion::flow_smoothing_test {
namespace {

constexpr double kFilamentMm2 = 2.4;

/// Returns a travel, then beads of 30 mm along x, each with its own speed and 1.2 mm of filament.
Toolpath Beads(std::initializer_list<int32_t> speeds_mm_s) {
  Toolpath path;
  Move move;
  move.kind = MoveKind::kTravel;
  move.feed_rate = 9'000;
  path.approach = 0;
  path.moves.push_back(move);
  move.kind = MoveKind::kPrint;
  move.filament = 120'000;
  for (const int32_t speed : speeds_mm_s) {
    move.x_um += 30'000;
    move.feed_rate = speed * 60;
    path.moves.push_back(move);
  }
  return path;
}

/// Checks the change of the flow at each joint, in mm^3/s^2, over the time of the faster piece.
/// Speeds are whole mm/min.
void ExpectSlopes(const Toolpath& path, const FlowSlopes& slopes) {
  for (size_t i = 2; i < path.moves.size(); ++i) {
    const auto flow = [&](size_t k) {
      const double mm = (path.moves[k].x_um - path.moves[k - 1].x_um) / 1000.0;
      return path.moves[k].filament / 1e5 * kFilamentMm2 / mm * path.moves[k].feed_rate / 60;
    };
    const double before = flow(i - 1), after = flow(i);
    const size_t faster = after > before ? i : i - 1;
    const double volume = path.moves[faster].filament / 1e5 * kFilamentMm2;
    const double slope = (after * after - before * before) / (2 * volume);
    const auto limit = [](double slope_limit) {
      return slope_limit > 0 ? slope_limit * 1.025 : 1e9;
    };
    EXPECT_LE(slope, limit(slopes.rise_mm3_s2)) << i;
    EXPECT_GE(slope, -limit(slopes.fall_mm3_s2)) << i;
  }
}

TEST(SmoothFlow, RisesAndFallsNoFasterThanAsked) {
  for (const FlowSlopes& slopes : {FlowSlopes{5, 0}, FlowSlopes{0, 8}, FlowSlopes{4, 20}}) {
    Toolpath path = Beads({20, 100, 30, 30, 80});
    SmoothFlow(slopes, kFilamentMm2, path);
    EXPECT_GT(path.moves.size(), 6);
    ExpectSlopes(path, slopes);
  }
}

TEST(SmoothFlow, PlacesAndFilamentStay) {
  Toolpath path = Beads({20, 100, 30});
  SmoothFlow({3, 3}, kFilamentMm2, path);
  int64_t filament = 0;
  for (const Move& move : path.moves) {
    filament += move.filament;
    EXPECT_EQ(move.filament > 0, move.kind == MoveKind::kPrint);
  }
  EXPECT_EQ(filament, 3 * 120'000);
  EXPECT_EQ(path.moves.back().x_um, 90'000);
  EXPECT_EQ(path.moves.back().feed_rate, 1'800) << "the slowest stays as it is";
}

TEST(SmoothFlow, EvenFlowStaysAsItIs) {
  Toolpath path = Beads({60, 60, 60});
  const Toolpath before = path;
  SmoothFlow({1, 1}, kFilamentMm2, path);
  EXPECT_EQ(path.moves, before.moves);
}

TEST(SmoothFlow, TravelsPartBeads) {
  Toolpath path = Beads({20, 100});
  path.moves.insert(path.moves.begin() + 2, path.moves[0]);
  path.moves[2].x_um = 30'000;
  const Toolpath before = path;
  SmoothFlow({1, 1}, kFilamentMm2, path);
  EXPECT_EQ(path.moves, before.moves);
}

TEST(SmoothFlow, LongerPiecesAreFewer) {
  size_t before = 1000;
  for (const double piece_mm : {0.5, 1.0, 3.0}) {
    Toolpath path = Beads({20, 100, 30});
    SmoothFlow({3, 3, piece_mm}, kFilamentMm2, path);
    EXPECT_LT(path.moves.size(), before);
    before = path.moves.size();
  }
}

TEST(SmoothFlow, OfOuterWallsOnly) {
  FlowSlopes slopes{5, 5};
  slopes.outer_walls = true;
  Toolpath path = Beads({20, 100});
  const std::vector<Move> before = path.moves;
  SmoothFlow(slopes, kFilamentMm2, path);
  EXPECT_EQ(path.moves, before) << "inner walls change their flow at once";
  for (Move& move : path.moves) move.feature = Feature::kExternalPerimeter;
  SmoothFlow(slopes, kFilamentMm2, path);
  EXPECT_GT(path.moves.size(), before.size());
}

}  // namespace
}  // namespace slicefarm::motion::flow_smoothing_test
