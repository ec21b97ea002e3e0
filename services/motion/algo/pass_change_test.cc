#include "services/motion/algo/pass_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::pass_change_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

/// Returns copies with the given numbers of layers of 0.2 mm, 100 mm apart.
ProgramSummary Passes(const std::vector<int32_t>& layer_counts) {
  ProgramSummary summary;
  for (int32_t pass = 0; pass < std::ssize(layer_counts); ++pass)
    for (int32_t i = 0; i < layer_counts[static_cast<size_t>(pass)]; ++i) {
      LayerSummary layer;
      layer.frame = {i, (i + 1) * Coord{200'000}, 200'000};
      layer.pass = pass;
      layer.entry = Mm(100 * pass, 1);
      layer.exit = Mm(100 * pass, 2);
      summary.layers.push_back(layer);
    }
  return summary;
}

MotionOptions Options() {
  MotionOptions options;
  options.travel_speed_mm_s = 100;
  options.travel_speed_z_mm_s = 10;
  return options;
}

std::string Gcode(const ProgramSummary& summary, size_t change, const MotionOptions& options) {
  return GcodeOf(PassChanges(summary).at(change), options.between_objects_gcode, options);
}

TEST(PassChanges, AreBetweenPassesOnly) {
  EXPECT_THAT(PassChanges({}), SizeIs(0));
  EXPECT_THAT(PassChanges(Passes({5})), SizeIs(0));
  const auto changes = PassChanges(Passes({3, 9, 2}));
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_EQ(changes[0].layer, 3u);
  EXPECT_EQ(changes[1].layer, 12u);
  EXPECT_EQ(changes[1].to, Mm(200, 1));
}

TEST(PassChanges, KnowTheHighestOfAllPassesBefore) {
  const auto changes = PassChanges(Passes({3, 9, 2, 4}));
  EXPECT_EQ(changes[0].top_nm, FromMm(0.6));
  EXPECT_EQ(changes[1].top_nm, FromMm(1.8));
  EXPECT_EQ(changes[2].top_nm, FromMm(1.8));
}

TEST(ClearHeight, IsAboveWhatStandsButNotAboveTheMachine) {
  MotionOptions options;
  EXPECT_EQ(ClearHeight(FromMm(20), options), FromMm(21));
  options.max_print_height_nm = FromMm(200);
  EXPECT_EQ(ClearHeight(FromMm(20), options), FromMm(21));
  EXPECT_EQ(ClearHeight(FromMm(199.5), options), FromMm(200));
  EXPECT_EQ(ClearHeight(FromMm(200), options), FromMm(200));
  EXPECT_EQ(ClearHeight(FromMm(201), options), FromMm(201));
}

TEST(PassChange, RisesBeforeItTravels) {
  MotionOptions options = Options();
  EXPECT_EQ(Gcode(Passes({3, 9, 2}), 1, options), "G1 Z2.8 F600\nG1 X200 Y1 F6000\n");
  options.z_offset_mm = 0.1;
  EXPECT_EQ(Gcode(Passes({3, 9, 2}), 1, options), "G1 Z2.9 F600\nG1 X200 Y1 F6000\n");
}

// The nozzle is high above the bed before it moves along the bed, for any G-code of the user.
TEST(PassChange, RisesAgainAfterTheUsersGcode) {
  MotionOptions options = Options();
  options.between_objects_gcode = "EJECT 2\nG1 Z0";
  EXPECT_EQ(Gcode(Passes({3, 9, 2}), 1, options),
            "G1 Z2.8 F600\nEJECT 2\nG1 Z0\nG21\nG90\nM83\nG1 Z2.8 F600\n"
            "G1 X200 Y1 F6000\n");
}

TEST(PassChange, GoesBackToTheFirstLayersTemperatures) {
  MotionOptions options = Options();
  options.tool().first_layer_temperature_c = 215;
  options.tool().first_layer_bed_temperature_c = 60;
  ProgramSummary summary = Passes({3, 2});
  EXPECT_THAT(Gcode(summary, 0, options), HasSubstr("\nM140 S60\nM104 S215\n"));
  options.between_objects_gcode = "M109 S230";
  EXPECT_THAT(Gcode(summary, 0, options), HasSubstr("\nM140 S60\nM109 S230\n"));
  options.between_objects_gcode = "M190 S70\nM104 S1";
  EXPECT_THAT(Gcode(summary, 0, options), Not(HasSubstr("M140")));
  options.between_objects_gcode = "";
  for (LayerSummary& layer : summary.layers) layer.frame.index += 2;
  EXPECT_THAT(Gcode(summary, 0, options), Not(HasSubstr("M1"))) << "what begins on a raft";
}

}  // namespace
}  // namespace slicefarm::motion::pass_change_test
