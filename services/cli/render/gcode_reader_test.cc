#include "services/cli/render/gcode_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace slicefarm::cli::gcode_reader_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Matches a run with these values and any speed.
auto Bead(const std::string& feature, double width_mm, const std::vector<Vector2>& points) {
  return testing::AllOf(testing::Field(&BeadRun::feature, feature),
                        testing::Field(&BeadRun::width_mm, width_mm),
                        testing::Field(&BeadRun::points, points));
}

GcodeLayer ReadOrDie(std::string_view gcode, int index) {
  auto layer = ReadGcodeLayer(gcode, index);
  if (!layer.ok()) {
    ADD_FAILURE() << layer.status();
    return {};
  }
  return *std::move(layer);
}

constexpr char kTwoLayers[] =
    "G90\nM83\nG1 X5 Y5 E3 ; purge, before any layer\n"
    ";LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n"
    "G1 Z.2 F7200\nG1 X0 Y0 F9000\nG1 E.8 F2100\n"
    ";TYPE:External perimeter\n;WIDTH:0.45\n"
    "G1 F1800\nG1 X10 Y0 E.3\nG1 X10 Y10 E.3\n"
    ";WIDTH:0.3\n"
    "G1 X0 Y10 E.2\n"
    "G1 E-.8\nG1 X2 Y2 F9000\nG1 E.8\n"
    ";TYPE:Solid infill\n;WIDTH:0.5\n"
    "G1 X8 Y2 E.2\n"
    ";LAYER_CHANGE\n;Z:0.45\n;HEIGHT:0.25\n"
    ";TYPE:Perimeter\n;WIDTH:0.4\nG1 X1 Y1\nG1 X2 Y1 E.1\n";

TEST(ReadGcodeLayer, ReadsBeadsWithFeatureAndWidth) {
  const GcodeLayer layer = ReadOrDie(kTwoLayers, 0);
  EXPECT_EQ(layer.layer_count, 2);
  EXPECT_EQ(layer.index, 0);
  EXPECT_DOUBLE_EQ(layer.z_mm, 0.2);
  EXPECT_DOUBLE_EQ(layer.height_mm, 0.2);
  EXPECT_THAT(layer.beads,
              ElementsAre(Bead("External perimeter", 0.45, {{0, 0}, {10, 0}, {10, 10}}),
                          Bead("External perimeter", 0.3, {{10, 10}, {0, 10}}),
                          Bead("Solid infill", 0.5, {{2, 2}, {8, 2}})));
  EXPECT_THAT(layer.travels, ElementsAre(ElementsAre(Vector2{5, 5}, Vector2{0, 0}),
                                         ElementsAre(Vector2{0, 10}, Vector2{2, 2})));
}

TEST(ReadGcodeLayer, SpeedsAndFlows) {
  const GcodeLayer layer = ReadOrDie(
      "M83\n;LAYER_CHANGE\nG1 X10 E.5 F1200\nG1 X20 E.5\nG1 X30 E.25 F2400\n"
      "; filament_diameter = 2\n",
      0);
  ASSERT_EQ(layer.beads.size(), 2) << "a run for each speed";
  EXPECT_DOUBLE_EQ(layer.beads[0].speed_mm_s, 20);
  EXPECT_NEAR(layer.beads[0].flow_mm3_s, 0.05 * 20 * 3.14159265, 1e-6);
  EXPECT_DOUBLE_EQ(layer.beads[1].speed_mm_s, 40);
  EXPECT_NEAR(layer.beads[1].flow_mm3_s, 0.025 * 40 * 3.14159265, 1e-6);
}

// Regression test: the time was stored as the energy.
TEST(ReadGcodeLayer, BeadsAreLaidWhenTheirLinesEnd) {
  std::vector<double> line_end_s(40);
  for (size_t line = 0; line < line_end_s.size(); ++line)
    line_end_s[line] = static_cast<double>(line);
  const auto layer = ReadGcodeLayer(kTwoLayers, 0, line_end_s);
  ASSERT_TRUE(layer.ok()) << layer.status();
  ASSERT_GE(layer->beads.size(), 3U);
  EXPECT_EQ(layer->beads.front().time_s, 0);
  for (size_t bead = 1; bead < layer->beads.size(); ++bead)
    EXPECT_GT(layer->beads[bead].time_s, layer->beads[bead - 1].time_s);
  for (const BeadRun& bead : layer->beads) EXPECT_EQ(bead.energy_j_mm, 0);
}

TEST(ReadGcodeLayer, FindsLaterLayers) {
  const GcodeLayer layer = ReadOrDie(kTwoLayers, 1);
  EXPECT_DOUBLE_EQ(layer.z_mm, 0.45);
  EXPECT_THAT(layer.beads, ElementsAre(Bead("Perimeter", 0.4, {{1, 1}, {2, 1}})));
}

TEST(ReadGcodeLayer, FollowsAbsoluteExtrusion) {
  const GcodeLayer layer = ReadOrDie(
      "M82\nG92 E0\n;LAYER_CHANGE\nG1 X1 Y0\nG1 X2 Y0 E1\nG1 X3 Y0 E1\nG1 X4 Y0 E1.5\nG92 E0\nG1 "
      "X5 Y0 E.5\n",
      0);
  ASSERT_EQ(layer.beads.size(), 2);
  EXPECT_THAT(layer.beads[0].points, ElementsAre(Vector2{1, 0}, Vector2{2, 0}));
  EXPECT_THAT(layer.beads[1].points, ElementsAre(Vector2{3, 0}, Vector2{4, 0}, Vector2{5, 0}));
}

TEST(ReadGcodeLayer, FollowsRelativeMovesAndArcs) {
  const GcodeLayer layer =
      ReadOrDie("M83\nG91\n;LAYER_CHANGE\nG1 X1 Y1 E1\nG1 X1 E1\nG90\nM83\nG2 X4 Y1 I1 J0 E1\n", 0);
  ASSERT_EQ(layer.beads.size(), 1);
  const std::vector<Vector2>& points = layer.beads[0].points;
  ASSERT_GT(points.size(), 12) << "half a turn of 1 mm, in chords";
  EXPECT_EQ(points[2], (Vector2{2, 1}));
  EXPECT_EQ(points.back(), (Vector2{4, 1}));
  for (size_t i = 3; i < points.size(); ++i) {
    EXPECT_NEAR(std::hypot(points[i].x() - 3, points[i].y() - 1), 1, 1e-9);
    EXPECT_GE(points[i].y(), 1 - 1e-9) << "clockwise: over the top";
  }
}

TEST(ReadGcodeLayer, PassesOverWhatItDoesNotKnow) {
  const GcodeLayer layer = ReadOrDie(
      "SET_VELOCITY_LIMIT ACCEL=1000\r\nM204 P1000 T1000\r\n;LAYER_CHANGE\r\nEXCLUDE_OBJECT_START "
      "NAME=X1\r\nM83\r\n;TYPE:Perimeter\r\n;WIDTH:nonsense\r\nG1 X1 E1 ;TYPE:no\r\nM117 G1 X99 "
      "E9\r\nG1\r\nG1 X Y2 E\r\n\r\n",
      0);
  EXPECT_THAT(layer.beads, ElementsAre(Bead("Perimeter", 0.4, {{0, 0}, {1, 0}})));
}

TEST(ReadGcodeLayer, PassesOverNumbersThatNoPrinterHas) {
  for (const std::string number : {"INF", "-inf", "NAN", "nan(1)", "1e300", "1e999", "-2e9"}) {
    const std::string gcode = "M83\n;LAYER_CHANGE\n;WIDTH:" + number + "\nG1 X1 Y1 E1\nG1 X" +
                              number + " Y2 E1\nG1 X3 Y2 E" + number + "\n";
    const GcodeLayer layer = ReadOrDie(gcode, 0);
    EXPECT_THAT(layer.beads, ElementsAre(Bead("Unknown", 0.4, {{0, 0}, {1, 1}, {1, 2}}))) << number;
  }
  for (const std::string width : {"0", "-4"}) {
    const GcodeLayer layer = ReadOrDie("M83\n;LAYER_CHANGE\n;WIDTH:" + width + "\nG1 X1 E1\n", 0);
    EXPECT_EQ(layer.beads[0].width_mm, 0.4);
  }
}

TEST(ReadGcodeLayer, TakesEmptyLayers) {
  const GcodeLayer layer = ReadOrDie(";LAYER_CHANGE\n;LAYER_CHANGE\n", 1);
  EXPECT_THAT(layer.beads, IsEmpty());
  EXPECT_EQ(layer.layer_count, 2);
}

TEST(ReadGcodeLayer, NamesTheLayersThereAre) {
  for (const int index : {-1, 2, 1000}) {
    const auto layer = ReadGcodeLayer(kTwoLayers, index);
    ASSERT_FALSE(layer.ok());
    EXPECT_TRUE(absl::IsInvalidArgument(layer.status()));
    EXPECT_THAT(std::string(layer.status().message()), HasSubstr("from 0 to 1"));
  }
  const auto none = ReadGcodeLayer("solid cube\n", 0);
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(std::string(none.status().message()), HasSubstr("LAYER_CHANGE"));
  EXPECT_FALSE(ReadGcodeLayer("", 0).ok());
}

}  // namespace
}  // namespace slicefarm::cli::gcode_reader_test
