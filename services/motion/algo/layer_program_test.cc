#include "services/motion/algo/layer_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "common/model/bead_section.h"
#include "common/base/error.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Path Line(Feature feature, std::string_view points, bool closed = false) {
  Path path = MakePathOrDie(points, closed);
  path.feature = feature;
  return path;
}

/// A square of 20 mm a side with a line of infill.
OrderedLayer Square(int32_t index = 2) {
  OrderedLayer layer;
  layer.frame = {index, (index + 1) * 200'000, 200'000};
  layer.paths = {Line(Feature::kExternalPerimeter, "(10 10, 30 10, 30 30, 10 30)", true),
                 Line(Feature::kInternalInfill, "(12 12, 28 28)")};
  return layer;
}

MotionOptions Options() {
  MotionOptions options;
  options.speed_mm_s = {40, 60, 30, 20, 80, 70, 50, 45, 60, 60};
  options.cooling.enabled = false;
  options.default_acceleration_mm_s2 = 1000;
  return options;
}

LayerProgram Programmed(const OrderedLayer& layer, const MotionOptions& options = Options()) {
  auto program = ProgramLayer(layer, options);
  EXPECT_TRUE(program.ok()) << program.status();
  return *std::move(program);
}

/// What a printer does with a program that starts retracted.
struct Printed {
  double filament_mm = 0;
  double retracted_mm = 0.8;
  double max_retracted_mm = 0;
  double extruded_mm = 0;
  double travel_mm = 0;
  double x = 0, y = 0, z = 0;
  double max_x = 0, max_y = 0;
  double least_feed_rate = 1e9;
  bool extruded_while_retracted = false;
};

Printed Print(const std::string& gcode) {
  Printed p;
  bool known = false;
  std::istringstream lines(gcode);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    std::string word;
    if (!(words >> word) || word != "G1") continue;
    std::map<char, double> value;
    while (words >> word) value[word[0]] = std::stod(word.substr(1));
    const double x = value.contains('X') ? value['X'] : p.x;
    const double y = value.contains('Y') ? value['Y'] : p.y;
    const double way = std::hypot(x - p.x, y - p.y);
    if (value.contains('F')) p.least_feed_rate = std::min(p.least_feed_rate, value['F']);
    if (value.contains('Z')) p.z = value['Z'];
    if (value.contains('X') && value.contains('E')) {
      p.filament_mm += value['E'];
      p.extruded_mm += way;
      p.extruded_while_retracted |= p.retracted_mm > 1e-9;
      p.max_x = std::max(p.max_x, x);
      p.max_y = std::max(p.max_y, y);
    } else if (value.contains('E')) {
      p.retracted_mm -= value['E'];
    } else if (value.contains('X') && known) {
      p.travel_mm += way;
    }
    known = known || value.contains('X');
    p.max_retracted_mm = std::max(p.max_retracted_mm, p.retracted_mm);
    p.x = x;
    p.y = y;
  }
  return p;
}

TEST(ProgramLayer, ASquareAsText) {
  EXPECT_EQ(Programmed(Square()).gcode,
            ";LAYER_CHANGE\n"
            ";Z:0.6\n"
            ";HEIGHT:0.2\n"
            ";BEFORE_LAYER_CHANGE\n"
            ";0.6\n"
            "M106 S89\n"
            "G1 Z.6 F1200\n"
            "G1 X10 Y10 F7800\n"
            "G1 E.8 F2100\n"
            ";TYPE:External perimeter\n"
            ";WIDTH:0.45\n"
            "M204 P1000\n"
            "G1 X30 Y10 E.67698 F2400\n"
            "G1 X30 Y30 E.67697\n"
            "G1 X10 Y30 E.67698\n"
            "G1 X10 Y10 E.67697\n"
            "G1 E-.8 F2100\n"
            "G1 X12 Y12 F7800\n"
            "G1 E.8 F2100\n"
            ";TYPE:Internal infill\n"
            ";WIDTH:0.45\n"
            "G1 X28 Y28 E.76592 F4800\n"
            "G1 E-.8 F2100\n");
}

TEST(ProgramLayer, ReadsBackAsPlanned) {
  const LayerProgram program = Programmed(Square());
  const Printed printed = Print(program.gcode);
  const MotionOptions options = Options();
  const double area =
      std::numbers::pi / 4 * options.filament_diameter_mm * options.filament_diameter_mm;
  const double length = 80 + std::hypot(16, 16);
  EXPECT_NEAR(printed.filament_mm * area, length * SectionMm2(450'000, 200'000), 3e-5);
  EXPECT_NEAR(printed.filament_mm, program.stats.FilamentMm(), 1e-9);
  EXPECT_NEAR(printed.extruded_mm, length, 1e-9);
  EXPECT_NEAR(printed.travel_mm, program.stats.travel_mm, 1e-9);
  EXPECT_DOUBLE_EQ(printed.z, 0.6);
  EXPECT_DOUBLE_EQ(printed.max_x, 30);
  EXPECT_FALSE(printed.extruded_while_retracted);
  EXPECT_DOUBLE_EQ(printed.retracted_mm, 0.8) << "ends as it starts";
  EXPECT_DOUBLE_EQ(printed.max_retracted_mm, 0.8);
  EXPECT_EQ(program.entry, (Point{FromMm(10), FromMm(10)}));
  EXPECT_EQ(program.exit, (Point{FromMm(28), FromMm(28)}));
}

TEST(ProgramLayer, RandomLayersKeepTheCanonicalState) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 20; ++trial) {
    OrderedLayer layer;
    layer.frame = {trial, 200'000 * (trial + 1), 200'000};
    for (int i = 0; i < 30; ++i) {
      Path path;
      path.feature = static_cast<Feature>(random() % kFeatureCount);
      path.closed = random() % 2 == 0;
      for (int k = 0; k < 6; ++k) {
        path.points.push_back({static_cast<Coord>(random() % 100'000'000),
                               static_cast<Coord>(random() % 100'000'000)});
        path.widths_nm.push_back(200'000 + static_cast<Coord>(random() % 500'000));
      }
      layer.paths.push_back(std::move(path));
    }
    MotionOptions options = Options();
    options.retraction.lift_mm = trial % 2 == 0 ? 0.2 : 0;
    options.flavor = static_cast<GcodeFlavor>(trial % 3);
    const LayerProgram program = Programmed(layer, options);
    const Printed printed = Print(program.gcode);
    EXPECT_NEAR(printed.retracted_mm, 0.8, 1e-9);
    EXPECT_FALSE(printed.extruded_while_retracted);
    EXPECT_NEAR(printed.filament_mm, program.stats.FilamentMm(), 1e-6);
    EXPECT_NEAR(printed.travel_mm, program.stats.travel_mm, 1e-6);
    EXPECT_GT(program.stats.TimeS(), printed.extruded_mm / 80);
  }
}

TEST(ProgramLayer, AnEmptyLayerMovesNothing) {
  OrderedLayer layer;
  layer.frame = {5, 1'200'000, 200'000};
  const LayerProgram program = Programmed(layer);
  EXPECT_EQ(program.gcode,
            ";LAYER_CHANGE\n;Z:1.2\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n;1.2\nM106 S89\n");
  EXPECT_EQ(program.stats.TimeS(), 0);
}

TEST(ProgramLayer, TemperaturesChangeWithTheSecondLayer) {
  MotionOptions options = Options();
  options.first_layer_temperature_c = 215;
  options.temperature_c = 205;
  options.bed_temperature_c = 55;
  options.first_layer_bed_temperature_c = 60;
  EXPECT_THAT(Programmed(Square(0), options).gcode, Not(HasSubstr("M104")));
  EXPECT_THAT(Programmed(Square(1), options).gcode, HasSubstr("M104 S205\nM140 S55\n"));
  EXPECT_THAT(Programmed(Square(2), options).gcode, Not(HasSubstr("M104")));
  options.temperature_c = 215;
  EXPECT_THAT(Programmed(Square(1), options).gcode, Not(HasSubstr("M104")));
}

TEST(ProgramLayer, FirstLayerIsSlowAndWithoutFan) {
  const LayerProgram program = Programmed(Square(0));
  EXPECT_THAT(program.gcode, HasSubstr("M107\n"));
  EXPECT_THAT(program.gcode, HasSubstr(" F1800\n"));
  EXPECT_THAT(program.gcode, Not(HasSubstr(" F4800\n")));
  EXPECT_EQ(Print(program.gcode).z, 0.2);
}

TEST(ProgramLayer, CustomCodeStandsAroundTheChangeOfHeight) {
  MotionOptions options = Options();
  options.before_layer_gcode = ";BEFORE_LAYER_CHANGE\nG92 E0.0\n;[layer_z]\n";
  options.layer_gcode = ";AFTER {layer_num}";
  const std::string gcode = Programmed(Square(), options).gcode;
  EXPECT_THAT(gcode, StartsWith(";LAYER_CHANGE\n;Z:0.6\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n"
                                "G92 E0.0\n;0.6\nM106 S89\nG1 Z.6 F1200\n;AFTER 2\n"
                                "G1 X10 Y10 F7800\n"));
}

TEST(ProgramLayer, AccelerationsOfCustomCodeEndWithIt) {
  MotionOptions options = Options();
  options.flavor = GcodeFlavor::kKlipper;
  options.travel_acceleration_mm_s2 = 3000;
  options.layer_gcode = "M204 S100";
  EXPECT_THAT(Programmed(Square(), options).gcode,
              HasSubstr("G1 Z.6 F1200\nM204 S100\nM204 S3000\nG1 X10 Y10"));
}

// Moves round to micrometres; the head of the layer has to say the same.
TEST(ProgramLayer, AHeightBetweenMicrometresIsSaidOnce) {
  for (const Coord height_nm : {200'500, 200'700, 201'300}) {
    OrderedLayer layer = Square();
    layer.frame.height_nm = height_nm;
    const std::string gcode = Programmed(layer).gcode;
    EXPECT_THAT(gcode, HasSubstr("\n;HEIGHT:0.201\n"));
    EXPECT_EQ(gcode.find(";HEIGHT:"), gcode.rfind(";HEIGHT:"));
  }
}

TEST(ProgramLayer, NamesTheTemplateThatIsWrong) {
  MotionOptions options = Options();
  options.layer_gcode = "[no_such_setting]";
  const auto program = ProgramLayer(Square(), options);
  const ErrorDetail detail = DetailOf(program.status());
  EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
  EXPECT_EQ(detail.metadata.at("setting"), "layer_gcode");
  EXPECT_EQ(detail.metadata.at("variable"), "no_such_setting");
}

TEST(ProgramLayer, CoolingSlowsShortLayersDown) {
  MotionOptions options = Options();
  options.cooling.enabled = true;
  options.cooling.slowdown_below_layer_time_s = 8;
  const LayerProgram program = Programmed(Square(), options);
  EXPECT_NEAR(program.stats.TimeS(), 8, 0.03);
  EXPECT_THAT(program.gcode, HasSubstr("M106 S255\n"));
  EXPECT_LT(Print(program.gcode).least_feed_rate, 2'400);
}

TEST(ProgramLayer, MovedPathsGiveMovedPrograms) {
  OrderedLayer moved = Square();
  for (Path& path : moved.paths) {
    for (Point& point : path.points) point = point + Point{FromMm(50), FromMm(-3)};
  }
  const ProgramStats here = Programmed(Square()).stats;
  const ProgramStats there = Programmed(moved).stats;
  EXPECT_DOUBLE_EQ(here.TimeS(), there.TimeS());
  EXPECT_DOUBLE_EQ(here.FilamentMm(), there.FilamentMm());
}

}  // namespace
}  // namespace slicefarm::motion
