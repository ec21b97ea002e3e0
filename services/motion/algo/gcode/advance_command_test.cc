#include "services/motion/algo/gcode/advance_command.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/model/options/machine_limits.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::advance_command_test {
namespace {

/// Returns a bead of 1 mm with 0.03 mm of filament, that is 2.16 mm3/s at 30 mm/s.
Move Bead(int32_t x_um, Feature feature, int32_t speed_mm_s, float acceleration) {
  Move move;
  move.kind = MoveKind::kPrint;
  move.feature = feature;
  move.x_um = x_um;
  move.filament = 3'000;
  move.feed_rate = speed_mm_s * 60;
  move.acceleration_mm_s2 = acceleration;
  return move;
}

AdvanceControl Control() {
  return {.model = AdvanceModel(
              {{0.05, 2.16, 1000}, {0.03, 4.32, 1000}, {0.04, 2.16, 3000}, {0.02, 4.32, 3000}}),
          .filament_mm2 = 2.4};
}

std::string Written(const std::vector<Move>& moves, const AdvanceControl& control) {
  Toolpath path;
  path.moves = moves;
  AdvanceCommand command(FirmwareOf(GcodeFlavor::kMarlin2), &control);
  GcodeText out;
  for (size_t i = 0; i < moves.size(); ++i)
    if (moves[i].kind == MoveKind::kPrint) command.SetFor(path, i, out);
  return out.Take();
}

const std::vector<Move> kMoves = {
    Move{}, Bead(1'000, Feature::kPerimeter, 30, 1000), Bead(2'000, Feature::kPerimeter, 60, 1000),
    Bead(3'000, Feature::kInternalInfill, 60, 3000), Bead(4'000, Feature::kBridgeInfill, 60, 3000)};

TEST(AdvanceCommand, TakesTheHighestSpeedOfAFeature) {
  EXPECT_EQ(Written(kMoves, Control()), "M900 K0.03\nM900 K0.02\n");
}

TEST(AdvanceCommand, FollowsTheFlowWithinAFeature) {
  AdvanceControl control = Control();
  control.within_features = true;
  EXPECT_EQ(Written(kMoves, control), "M900 K0.05\nM900 K0.03\nM900 K0.02\n");
}

TEST(AdvanceCommand, BridgesHaveTheirOwnValue) {
  AdvanceControl control = Control();
  control.bridges = 0.07;
  EXPECT_EQ(Written(kMoves, control), "M900 K0.03\nM900 K0.02\nM900 K0.07\n");
}

TEST(AdvanceCommand, IsWrittenAgainAfterForget) {
  const AdvanceControl control = Control();
  Toolpath path;
  path.moves = kMoves;
  AdvanceCommand command(FirmwareOf(GcodeFlavor::kMarlin2), &control);
  GcodeText out;
  command.SetFor(path, 1, out);
  command.SetFor(path, 2, out);
  EXPECT_EQ(out.text(), "M900 K0.03\n");
  command.Forget();
  command.SetFor(path, 2, out);
  EXPECT_EQ(out.text(), "M900 K0.03\nM900 K0.03\n");
}

TEST(AdvanceControl, NeedsAModel) {
  MotionOptions options;
  EXPECT_FALSE(AdvanceControl::Of(options));
  options.tool().advance.on = true;
  EXPECT_FALSE(AdvanceControl::Of(options));
  options.tool().advance.model = "0.04,4,3000;0.03,8,3000";
  ASSERT_TRUE(AdvanceControl::Of(options));
  EXPECT_NEAR(AdvanceControl::Of(options)->filament_mm2, 2.405, 0.001);
}

}  // namespace
}  // namespace slicefarm::motion::advance_command_test
