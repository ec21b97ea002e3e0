#include "services/motion/algo/toolpath/move_arcs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace slicefarm::motion::move_arcs_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns a travel to (10, 0), then a quarter of a circle of 10 mm around the origin in 30 moves.
Toolpath Quarter() {
  Toolpath path;
  path.moves.push_back({.x_um = 10'000});
  for (int i = 1; i <= 30; ++i) {
    const double angle = i * std::numbers::pi / 60;
    path.moves.push_back({.x_um = static_cast<int32_t>(std::lround(10'000 * std::cos(angle))),
                          .y_um = static_cast<int32_t>(std::lround(10'000 * std::sin(angle))),
                          .filament = 3'000,
                          .feed_rate = 1'800,
                          .width_um = 450,
                          .height_um = 200,
                          .kind = MoveKind::kPrint,
                          .on_arc = true});
  }
  return path;
}

TEST(FindArcs, OneForAQuarterOfACircle) {
  Toolpath path = Quarter();
  FindArcs(path);
  EXPECT_THAT(path.arcs, ElementsAre(MoveArc{1, 31, {0, 0}, false}));
  FindArcs(path);
  EXPECT_EQ(path.arcs.size(), 1u) << "found anew";
}

TEST(FindArcs, OtherWayRound) {
  Toolpath path = Quarter();
  for (Move& move : path.moves) move.y_um = -move.y_um;
  FindArcs(path);
  EXPECT_THAT(path.arcs, ElementsAre(MoveArc{1, 31, {0, 0}, true}));
}

struct BeadCase {
  std::string name;
  std::function<void(Move&)> change;
};

// A move with another bead ends the arc before it and is in no arc.
TEST(FindArcs, OfEqualBeadsOnly) {
  const std::vector<BeadCase> cases = {
      {"width", [](Move& m) { m.width_um = 460; }},
      {"height", [](Move& m) { m.height_um = 210; }},
      {"speed", [](Move& m) { m.feed_rate = 1'700; }},
      {"feature", [](Move& m) { m.feature = Feature::kSolidInfill; }},
      {"rest", [](Move& m) { m.rest = 3; }},
      {"rise", [](Move& m) { m.z_um = 10; }},
      {"acceleration", [](Move& m) { m.acceleration_mm_s2 = 500; }},
      {"simplified", [](Move& m) { m.on_arc = false; }},
      {"travel", [](Move& m) { m.kind = MoveKind::kTravel; }},
  };
  for (const BeadCase& c : cases) {
    Toolpath path = Quarter();
    c.change(path.moves[15]);
    FindArcs(path);
    EXPECT_GE(path.arcs.size(), 1u) << c.name;
    for (const MoveArc& arc : path.arcs) EXPECT_TRUE(arc.last <= 15 || arc.first > 15) << c.name;
  }
}

TEST(FindArcs, NoneInStraightLines) {
  Toolpath path = Quarter();
  for (size_t i = 0; i < path.moves.size(); ++i) path.moves[i].y_um = 0;
  FindArcs(path);
  EXPECT_THAT(path.arcs, IsEmpty());
  Toolpath nothing;
  FindArcs(nothing);
  EXPECT_THAT(nothing.arcs, IsEmpty());
}

}  // namespace
}  // namespace slicefarm::motion::move_arcs_test
