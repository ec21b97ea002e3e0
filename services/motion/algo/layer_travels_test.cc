#include "services/motion/algo/layer_travels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/pass_change.h"

namespace slicefarm::motion::layer_travels_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

MultiPolygon Box(double x0, double y0, double x1, double y1) {
  return {{{Mm(x0, y0), Mm(x1, y0), Mm(x1, y1), Mm(x0, y1)}, {}}};
}

/// A machine with a cutter in its front left corner and a nozzle offset of 2 mm.
MotionOptions Options() {
  MotionOptions options;
  options.travel_area = Difference(Box(0, 0, 256, 256), Box(0, 0, 18, 28));
  options.tool().offset = Mm(0, 2);
  options.travel_speed_mm_s = 100;
  options.tool().retraction.lift_mm = 0.4;
  return options;
}

LayerSummary LayerAt(Point entry) {
  LayerSummary layer;
  layer.frame = {.index = 4, .print_z_nm = FromMm(1), .height_nm = FromMm(0.2)};
  layer.entry = entry;
  return layer;
}

TEST(LayerTravels, AreStraightWhereNothingIsInTheWay) {
  const MotionOptions options = Options();
  EXPECT_THAT(LayerTravels(options).To(LayerAt(Mm(100, 100)), Mm(30, 30)), IsEmpty());
  MotionOptions open = Options();
  open.travel_area.clear();
  EXPECT_THAT(LayerTravels(open).To(LayerAt(Mm(2, 30)), Mm(30, 2)), IsEmpty());
}

TEST(LayerTravels, GoRoundAnAreaAtTheHeightOfTravel) {
  const MotionOptions options = Options();
  EXPECT_THAT(LayerTravels(options).To(LayerAt(Mm(2, 30)), Mm(20, 0)),
              MatchesRegex("G1 Z1\\.4 F[0-9]+\nG1 X18\\.3[0-9]+ Y26\\.3[0-9]+ F6000\n"))
      << "the area ends at y = 26 for the machine";
}

TEST(LayerTravels, KnowWhereGcodeLeavesTheNozzle) {
  const MotionOptions options = Options();
  const LayerTravels travels(options);
  EXPECT_EQ(travels.After("G28\nG1 X10 Y20 F3000\nG91\nG1 X5\nG90", {}), Mm(15, 20));
  EXPECT_EQ(travels.After("M400\n", Mm(7, 8)), Mm(7, 8));
}

TEST(PassChange, GoesRoundAnArea) {
  PassChange change;
  change.from = Mm(20, 0);
  change.to = Mm(2, 30);
  EXPECT_THAT(GcodeOf(change, "", Options()), HasSubstr("G1 X18.3"));
  EXPECT_THAT(GcodeOf(change, "G1 X100 Y100 F3000", Options()), Not(HasSubstr("G1 X18.3")));
  change.from = Mm(100, 100);
  EXPECT_THAT(GcodeOf(change, "", Options()), Not(HasSubstr("G1 X18.3")));
}

}  // namespace
}  // namespace slicefarm::motion::layer_travels_test
