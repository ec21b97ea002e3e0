#include "services/motion/algo/layer_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/bead_section.h"
#include "common/model/options/machine_limits.h"
#include "common/model/options/motion_options.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion::layer_program_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Path Line(Feature feature, std::string_view points, bool closed = false) {
  Path path = MakePathOrDie(points, closed);
  path.feature = feature;
  return path;
}

/// Returns a square of 20 mm per side with a line of infill.
OrderedLayer Square(int32_t index = 2) {
  OrderedLayer layer;
  layer.frame = {index, (index + 1) * 200'000, 200'000};
  layer.blocks = {{0,
                   index,
                   layer.frame.height_nm,
                   {Line(Feature::kExternalPerimeter, "(10 10, 30 10, 30 30, 10 30)", true),
                    Line(Feature::kInternalInfill, "(12 12, 28 28)")}}};
  layer.visits = {{0, 0, 0, {}}};
  return layer;
}

/// Returns the square, and a copy of it 50 mm to the right.
OrderedLayer TwoSquares(int32_t pass_of_second = 0) {
  OrderedLayer layer = Square();
  layer.visits.push_back({0, 1, pass_of_second, {FromMm(50), 0}});
  return layer;
}

MotionOptions Options() {
  MotionOptions options;
  options.speeds[0].speed_mm_s = {40, 60, 30, 20, 80, 70, 50, 45, 60, 60};
  options.tool().cooling.enabled = false;
  options.default_acceleration_mm_s2 = 1000;
  return options;
}

/// Returns the names of all copies in these layers.
JobFacts Facts() {
  JobFacts facts;
  facts.copies = {{"a", 0, 0, 2}, {"a", 0, 1, 2}};
  return facts;
}

absl::StatusOr<std::vector<LayerProgram>> Program(const OrderedLayer& layer, const JobFacts& facts,
                                                  const MotionOptions& options) {
  const auto code = LayerCode::Of(options);
  if (!code.ok()) return code.status();
  return ProgramLayer(layer, facts, options, *code);
}

std::vector<LayerProgram> Passes(const OrderedLayer& layer,
                                 const MotionOptions& options = Options()) {
  auto programs = Program(layer, Facts(), options);
  EXPECT_TRUE(programs.ok()) << programs.status();
  return *std::move(programs);
}

/// Returns the program of a layer with one pass.
LayerProgram Programmed(const OrderedLayer& layer, const MotionOptions& options = Options()) {
  std::vector<LayerProgram> programs = Passes(layer, options);
  EXPECT_EQ(programs.size(), 1);
  return std::move(programs.front());
}

/// Simulated result of a program that starts retracted.
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
    const double travel = std::hypot(x - p.x, y - p.y);
    if (value.contains('F')) p.least_feed_rate = std::min(p.least_feed_rate, value['F']);
    if (value.contains('Z')) p.z = value['Z'];
    const bool moves = value.contains('X') || value.contains('Y');
    if (moves && value.contains('E')) {
      p.filament_mm += value['E'];
      p.extruded_mm += travel;
      p.extruded_while_retracted |= p.retracted_mm > 1e-9;
      p.max_x = std::max(p.max_x, x);
      p.max_y = std::max(p.max_y, y);
    } else if (value.contains('E')) {
      p.retracted_mm -= value['E'];
    } else if (moves && known) {
      p.travel_mm += travel;
    }
    known = known || moves;
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
            "G1 Y30 E.67697\n"
            "G1 X10 E.67698\n"
            "G1 Y10 E.67697\n"
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
  const double area = std::numbers::pi / 4 * options.tool().filament_diameter_mm *
                      options.tool().filament_diameter_mm;
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

/// `unit_nm`: all coordinates are multiples of this.
Path RandomPath(std::mt19937& random, Coord unit_nm = 1) {
  Path path;
  path.feature = static_cast<Feature>(random() % kFeatureCount);
  path.closed = random() % 2 == 0;
  const auto coordinate = [&] {
    return static_cast<Coord>(random() % 100'000'000) / unit_nm * unit_nm;
  };
  for (int k = 0; k < 6; ++k) {
    const Coord x = coordinate();
    path.points.push_back({x, coordinate()});
    path.widths_nm.push_back(200'000 + static_cast<Coord>(random() % 500'000));
  }
  return path;
}

MotionOptions OptionsOfTrial(int trial) {
  MotionOptions options = Options();
  options.tool().retraction.lift_mm = trial % 2 == 0 ? 0.2 : 0;
  options.flavor = static_cast<GcodeFlavor>(trial % 3);
  options.labels = static_cast<ObjectLabels>(trial / 2 % 3);
  return options;
}

void ExpectCanonical(const LayerProgram& program) {
  const Printed printed = Print(program.gcode);
  EXPECT_NEAR(printed.retracted_mm, 0.8, 1e-9);
  EXPECT_FALSE(printed.extruded_while_retracted);
  EXPECT_NEAR(printed.filament_mm, program.stats.FilamentMm(), 1e-6);
  EXPECT_NEAR(printed.travel_mm, program.stats.travel_mm, 1e-6);
  EXPECT_GT(program.stats.TimeS(), printed.extruded_mm / 80);
}

TEST(ProgramLayer, RandomLayersKeepTheCanonicalState) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 20; ++trial) {
    OrderedLayer layer;
    layer.frame = {trial, 200'000 * (trial + 1), 200'000};
    layer.blocks.push_back({0, trial, 200'000, {}});
    for (int i = 0; i < 30; ++i) layer.blocks[0].paths.push_back(RandomPath(random));
    layer.visits = {{0, 0, 0, {}}};
    ExpectCanonical(Programmed(layer, OptionsOfTrial(trial)));
  }
}

TEST(ProgramLayer, RandomCopiesKeepTheCanonicalState) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    OrderedLayer layer;
    layer.frame = {trial, 200'000 * (trial + 1), 200'000};
    for (int32_t object = 0; object < 3; ++object) {
      layer.blocks.push_back({object, trial, object == 1 ? 150'000 : 200'000, {}});
      for (int i = 0; i < 5; ++i) layer.blocks.back().paths.push_back(RandomPath(random, 1'000));
    }
    for (int i = 0; i < 9; ++i) {
      const auto um = [&] { return static_cast<Coord>(random() % 90'000) * 1'000; };
      const Coord x = um();
      layer.visits.push_back({static_cast<int32_t>(random() % 3), i % 2, i / 3, {x, um()}});
    }
    const std::vector<LayerProgram> programs = Passes(layer, OptionsOfTrial(trial));
    ASSERT_EQ(programs.size(), 3);
    for (const LayerProgram& program : programs) {
      ExpectCanonical(program);
      EXPECT_NEAR(Print(program.gcode).z, ToMm(static_cast<double>(layer.frame.print_z_nm)), 1e-9);
    }
  }
}

TEST(ProgramLayer, AnEmptyLayerMovesNothing) {
  OrderedLayer layer;
  layer.frame = {5, 1'200'000, 200'000};
  const LayerProgram program = Programmed(layer);
  EXPECT_EQ(program.gcode, ";LAYER_CHANGE\n;Z:1.2\n;HEIGHT:0.2\n;BEFORE_LAYER_CHANGE\n;1.2\n");
  EXPECT_EQ(program.stats.TimeS(), 0);
}

// The fan stays as in the layer of the part below, because supports are printed between the part's
// own layers.
TEST(ProgramLayer, SupportsAloneLeaveTheFanAsItIs) {
  OrderedLayer layer = Square();
  layer.blocks[0].stack.kind = StackKind::kSupport;
  for (Path& path : layer.blocks[0].paths) path.feature = Feature::kSupport;
  LayerProgram program = Programmed(layer);
  EXPECT_EQ(program.gcode.find("M10"), std::string::npos) << program.gcode;
  EXPECT_EQ(program.modes_at_end.value()[static_cast<size_t>(MachineMode::kFan)], "");
  layer.frame.index = 0;
  EXPECT_THAT(Programmed(layer).gcode, HasSubstr("M107\n")) << "start G-code may have left it on";
}

TEST(ProgramLayer, SaysWhichLinesMayBeSuperfluous) {
  MotionOptions options = Options();
  options.travel_acceleration_mm_s2 = 3000;
  const LayerProgram program = Programmed(Square(), options);
  std::vector<std::pair<MachineMode, std::string>> lines;
  for (const ModeLine& line : program.mode_lines)
    lines.emplace_back(line.mode, program.gcode.substr(static_cast<size_t>(line.at),
                                                       static_cast<size_t>(line.size)));
  using enum MachineMode;
  EXPECT_EQ(lines,
            (std::vector<std::pair<MachineMode, std::string>>{{kFan, "M106 S89\n"},
                                                              {kTravelAcceleration, "M204 T3000\n"},
                                                              {kPosition, "G1 X10 Y10 F7800\n"},
                                                              {kAcceleration, "M204 P1000\n"}}));
  EXPECT_EQ(program.mode_lines[2].value, "10000 10000");
  EXPECT_EQ(program.modes_at_end,
            (ModeValues{"M106 S89\n", "M204 P1000\n", "M204 T3000\n", "28000 28000", ""}));
  options.layer_gcode = "M117 hi";
  EXPECT_TRUE(Programmed(Square(), options).modes_at_end.has_value());
  options.layer_gcode = "G1 X5";
  EXPECT_FALSE(Programmed(Square(), options).modes_at_end.has_value());
}

TEST(ProgramLayer, OnlyTheFirstLayerHasAFootprint) {
  EXPECT_TRUE(Programmed(Square(1)).footprint.empty());
  const Box box = Bounds(Programmed(Square(0)).footprint);
  EXPECT_EQ(box, (Box{{FromMm(9.775), FromMm(9.775)}, {FromMm(30.225), FromMm(30.225)}}));
}

TEST(ProgramLayer, TimesInSilentModeAreThoseOfItsLimits) {
  MotionOptions options = Options();
  EXPECT_EQ(Programmed(Square(), options).silent_time_s, 0);
  options.silent_limits = options.limits;
  EXPECT_NEAR(Programmed(Square(), options).silent_time_s, Programmed(Square()).stats.TimeS(),
              1e-9);
  options.silent_limits->max_acceleration_mm_s2 = {100, 100, 100, 100};
  const LayerProgram program = Programmed(Square(), options);
  EXPECT_GT(program.silent_time_s, 1.2 * program.stats.TimeS());
}

TEST(ProgramLayer, TemperaturesChangeWithTheSecondLayer) {
  MotionOptions options = Options();
  options.tool().first_layer_temperature_c = 215;
  options.tool().temperature_c = 205;
  options.tool().bed_temperature_c = 55;
  options.tool().first_layer_bed_temperature_c = 60;
  EXPECT_THAT(Programmed(Square(0), options).gcode, Not(HasSubstr("M104")));
  EXPECT_THAT(Programmed(Square(1), options).gcode, HasSubstr("M104 S205\nM140 S55\n"));
  EXPECT_THAT(Programmed(Square(2), options).gcode, Not(HasSubstr("M104")));
  options.tool().temperature_c = 215;
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

// Moves are rounded to micrometres. The head of the layer must contain the same value.
TEST(ProgramLayer, AHeightBetweenMicrometresIsSaidOnce) {
  for (const Coord height_nm : {200'500, 200'700, 201'300}) {
    OrderedLayer layer = Square();
    layer.frame.height_nm = layer.blocks[0].height_nm = height_nm;
    const std::string gcode = Programmed(layer).gcode;
    EXPECT_THAT(gcode, HasSubstr("\n;HEIGHT:0.201\n"));
    EXPECT_EQ(gcode.find(";HEIGHT:"), gcode.rfind(";HEIGHT:"));
  }
}

// Templates that depend on earlier layers are left out, and their positions are returned.
TEST(ProgramLayer, KeepsPlacesForCodeThatWaits) {
  MotionOptions options = Options();
  options.before_layer_gcode = ";BEFORE_LAYER_CHANGE\nM117 {extruded_weight_total}";
  options.layer_gcode = "M118 {layer_num}";
  const LayerProgram program = Programmed(Square(), options);
  ASSERT_EQ(program.code_at.size(), 2u);
  EXPECT_THAT(program.gcode, Not(HasSubstr("M117")));
  EXPECT_THAT(program.gcode, Not(HasSubstr("M118")));
  std::string filled = program.gcode;
  filled.insert(static_cast<size_t>(program.code_at[1]), "M118 2\n");
  filled.insert(static_cast<size_t>(program.code_at[0]), ";BEFORE_LAYER_CHANGE\nM117 7\n");
  options.before_layer_gcode = ";BEFORE_LAYER_CHANGE\nM117 7";
  const LayerProgram direct = Programmed(Square(), options);
  EXPECT_TRUE(direct.code_at.empty());
  EXPECT_EQ(filled, direct.gcode);
}

TEST(ProgramLayer, NamesTheTemplateThatIsWrong) {
  MotionOptions options = Options();
  options.layer_gcode = "[no_such_setting]";
  const auto program = Program(Square(), {}, options);
  const ErrorDetail detail = DetailOf(program.status());
  EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
  EXPECT_EQ(detail.metadata.at("setting"), "layer_gcode");
  EXPECT_EQ(detail.metadata.at("variable"), "no_such_setting");
}

TEST(ProgramLayer, CoolingSlowsShortLayersDown) {
  MotionOptions options = Options();
  options.tool().cooling.enabled = true;
  options.tool().cooling.slowdown_below_layer_time_s = 8;
  const LayerProgram program = Programmed(Square(), options);
  EXPECT_NEAR(program.stats.TimeS(), 8, 0.03);
  EXPECT_THAT(program.gcode, HasSubstr("M106 S255\n"));
  EXPECT_LT(Print(program.gcode).least_feed_rate, 2'400);
}

TEST(ProgramLayer, MovedPathsGiveMovedPrograms) {
  OrderedLayer moved = Square();
  for (Path& path : moved.blocks[0].paths) {
    for (Point& point : path.points) point = point + Point{FromMm(50), FromMm(-3)};
  }
  const ProgramStats here = Programmed(Square()).stats;
  const ProgramStats there = Programmed(moved).stats;
  EXPECT_DOUBLE_EQ(here.TimeS(), there.TimeS());
  EXPECT_DOUBLE_EQ(here.FilamentMm(), there.FilamentMm());
}

TEST(ProgramLayer, AShiftedCopyIsAsMovedPathsAre) {
  const Point shift{FromMm(50), FromMm(-3)};
  OrderedLayer moved = Square();
  for (Path& path : moved.blocks[0].paths) {
    for (Point& point : path.points) point = point + shift;
  }
  OrderedLayer shifted = Square();
  shifted.visits[0].shift = shift;
  EXPECT_EQ(Programmed(shifted), Programmed(moved));
}

/// Only the coordinates in the G-code change. The places on the plate stay the same.
TEST(ProgramLayer, TheExtrudersOffsetIsTakenOffAllPlaces) {
  MotionOptions options = Options();
  const LayerProgram plain = Programmed(TwoSquares(), options);
  options.tool().offset = {FromMm(-1.5), FromMm(2)};
  const LayerProgram offset = Programmed(TwoSquares(), options);
  OrderedLayer moved = TwoSquares();
  for (BlockVisit& visit : moved.visits) visit.shift = visit.shift - options.tool().offset;
  EXPECT_EQ(offset.gcode, Programmed(moved).gcode);
  EXPECT_EQ(offset.entry, plain.entry - options.tool().offset);
  EXPECT_EQ(offset.exit, plain.exit - options.tool().offset);
  EXPECT_EQ(offset.stats, plain.stats);
}

TEST(ProgramLayer, CodeThatMovesInZIsFollowedByAHeight) {
  MotionOptions options = Options();
  const auto after_code = [&](const char* code) {
    options.layer_gcode = code;
    const std::string gcode = Programmed(Square(), options).gcode;
    const size_t line = gcode.find("G1 X", gcode.find(code));
    return gcode.substr(line, gcode.find('\n', line) - line);
  };
  EXPECT_THAT(after_code("M117"), Not(HasSubstr("Z")));
  EXPECT_THAT(after_code("G1 Z9 ; look"), HasSubstr(" Z"));
}

TEST(ProgramLayer, CopiesAsText) {
  MotionOptions options = Options();
  options.labels = ObjectLabels::kComments;
  OrderedLayer layer = TwoSquares();
  layer.blocks[0].paths.resize(1);
  EXPECT_EQ(Programmed(layer, options).gcode,
            ";LAYER_CHANGE\n"
            ";Z:0.6\n"
            ";HEIGHT:0.2\n"
            ";BEFORE_LAYER_CHANGE\n"
            ";0.6\n"
            "M106 S89\n"
            "G1 Z.6 F1200\n"
            "G1 X10 Y10 F7800\n"
            "; printing object a id:0 copy 0\n"
            "G1 E.8 F2100\n"
            ";TYPE:External perimeter\n"
            ";WIDTH:0.45\n"
            "M204 P1000\n"
            "G1 X30 Y10 E.67698 F2400\n"
            "G1 Y30 E.67697\n"
            "G1 X10 E.67698\n"
            "G1 Y10 E.67697\n"
            "G1 E-.8 F2100\n"
            "; stop printing object a id:0 copy 0\n"
            "G1 X60 Y10 F7800\n"
            "; printing object a id:0 copy 1\n"
            "G1 E.8 F2100\n"
            ";TYPE:External perimeter\n"
            ";WIDTH:0.45\n"
            "M204 P1000\n"
            "G1 X80 Y10 E.67698 F2400\n"
            "G1 Y30 E.67697\n"
            "G1 X60 E.67698\n"
            "G1 Y10 E.67697\n"
            "G1 E-.8 F2100\n"
            "; stop printing object a id:0 copy 1\n");
}

TEST(ProgramLayer, CopiesAreCountedWithTheWayBetweenThem) {
  const LayerProgram one = Programmed(Square());
  const LayerProgram two = Programmed(TwoSquares());
  EXPECT_NEAR(two.stats.FilamentMm(), 2 * one.stats.FilamentMm(), 1e-9);
  EXPECT_EQ(two.stats.travels, 2 * one.stats.travels);
  EXPECT_EQ(two.stats.retractions, 2 * one.stats.retractions);
  EXPECT_NEAR(two.stats.travel_mm, 2 * one.stats.travel_mm + std::hypot(32, 18), 1e-9);
  EXPECT_EQ(two.stats.bounds.min, one.stats.bounds.min);
  EXPECT_EQ(two.stats.bounds.max, one.stats.bounds.max + Point({FromMm(50), 0}));
  EXPECT_EQ(two.entry, one.entry);
  EXPECT_EQ(two.exit, one.exit + Point({FromMm(50), 0}));
  EXPECT_GT(two.stats.travel_time_s, 2 * one.stats.travel_time_s - 0.1);
}

// The position of a copy must not change its print: it has the same moves and the same speed.
TEST(ProgramLayer, TheWayToACopyGoesOverItsCorners) {
  const OrderedLayer straight = TwoSquares();
  OrderedLayer round = straight;
  round.visits[1].corners = {{FromMm(35), FromMm(40)}, {FromMm(50), FromMm(40)}};
  for (const double lift_mm : {0.0, 0.4}) {
    MotionOptions options = Options();
    options.tool().retraction.lift_mm = lift_mm;
    const LayerProgram before = Programmed(straight, options), after = Programmed(round, options);
    EXPECT_THAT(after.gcode, HasSubstr("X35 Y40"));
    const Printed direct = Print(before.gcode), led = Print(after.gcode);
    const double more_mm = std::hypot(35 - 28, 40 - 28) + 15 + std::hypot(60 - 50, 40 - 10) -
                           std::hypot(60 - 28, 28 - 10);
    EXPECT_NEAR(led.travel_mm - direct.travel_mm, more_mm, 1e-6) << lift_mm;
    EXPECT_NEAR(after.stats.travel_mm - before.stats.travel_mm, more_mm, 1e-6);
    EXPECT_GT(after.stats.travel_time_s, before.stats.travel_time_s);
    EXPECT_EQ(led.extruded_mm, direct.extruded_mm);
    EXPECT_EQ(led.z, direct.z);
    EXPECT_EQ(after.edges.head, before.edges.head);
  }
}

TEST(ProgramLayer, ThePlaceOfACopyChangesNothingButItsPlace) {
  OrderedLayer far = TwoSquares();
  far.visits[1].shift = {FromMm(100), FromMm(70)};
  const std::string near_by = Programmed(TwoSquares()).gcode;
  const std::string far_off = Programmed(far).gcode;
  const size_t second = near_by.find("G1 X60 Y10");
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(far_off.substr(0, second), near_by.substr(0, second));
  EXPECT_DOUBLE_EQ(Print(far_off).filament_mm, Print(near_by).filament_mm);
  EXPECT_EQ(Print(far_off).max_x, 130);
  EXPECT_EQ(Print(far_off).max_y, 100);
}

TEST(ProgramLayer, EachPassIsAProgram) {
  const OrderedLayer layer = TwoSquares(3);
  const std::vector<LayerProgram> programs = Passes(layer);
  ASSERT_EQ(programs.size(), 2);
  EXPECT_EQ(programs[0], Programmed(Square()));
  OrderedLayer second = layer;
  second.visits.erase(second.visits.begin());
  EXPECT_EQ(programs[1], Programmed(second));
  EXPECT_EQ(programs[1].pass, 3);
  EXPECT_EQ(programs[1].frame, layer.frame);
  EXPECT_EQ(programs[1].entry, (Point{FromMm(60), FromMm(10)}));
}

// The job's third layer is the second layer of a copy with layers twice as high.
TEST(ProgramLayer, ACopyInAPassOfItsOwnCountsItsOwnLayers) {
  OrderedLayer layer = TwoSquares(1);
  layer.blocks.push_back(layer.blocks[0]);
  layer.blocks[1].layer = 1;
  layer.visits[1].block = 1;
  MotionOptions options = Options();
  options.tool().first_layer_temperature_c = 215;
  options.layer_gcode = "NOW {layer_num} {max_layer_z} {current_object_idx}";
  options.tool().cooling.enabled = true;
  options.tool().cooling.disable_fan_first_layers = 2;
  JobFacts facts = Facts();
  facts.passes = {{0, 0, 0}, {30, 0, FromMm(6)}};
  const auto programs = Program(layer, facts, options);
  ASSERT_TRUE(programs.ok()) << programs.status();
  ASSERT_EQ(programs->size(), 2);
  const std::string& first = programs->front().gcode;
  const std::string& second = programs->back().gcode;
  EXPECT_THAT(first, HasSubstr("\nNOW 2 0.6 0\n"));
  EXPECT_THAT(first, Not(HasSubstr("M104")));
  EXPECT_THAT(first, HasSubstr("M106"));
  EXPECT_THAT(second, HasSubstr("\nNOW 31 6 1\n"));
  EXPECT_THAT(second, HasSubstr("M104 S200\n"));
  EXPECT_THAT(second, HasSubstr("M107"));
  options.layer_gcode = "{current_object_idx / (1 - current_object_idx)}";
  EXPECT_FALSE(Program(layer, facts, options).ok()) << "of the second pass alone";
}

TEST(ProgramLayer, ThePlatesOwnPathsHaveNoLabel) {
  MotionOptions options = Options();
  options.labels = ObjectLabels::kFirmware;
  OrderedLayer layer = Square();
  layer.blocks.insert(layer.blocks.begin(),
                      {kSkirtStack, 2, 200'000, {Line(Feature::kSkirt, "(5 5, 35 5)")}});
  layer.visits = {{0, -1, 0, {}}, {1, 1, 0, {}}};
  const std::string gcode = Programmed(layer, options).gcode;
  const size_t label = gcode.find("M486");
  EXPECT_LT(gcode.find(";TYPE:Skirt"), label);
  EXPECT_EQ(gcode.substr(label, 8), "M486 S1\n");
  EXPECT_THAT(gcode, testing::EndsWith("G1 E-.8 F2100\nM486 S-1\n"));
}

TEST(ProgramLayer, ABlockOfAnotherHeightSaysSo) {
  OrderedLayer layer = TwoSquares();
  layer.blocks.push_back(layer.blocks[0]);
  layer.blocks[1].height_nm = 100'000;
  layer.visits = {{1, 0, 0, {}}, {0, 1, 0, {FromMm(50), 0}}};
  const LayerProgram program = Programmed(layer);
  const std::string& gcode = program.gcode;
  const size_t own = gcode.find("\n;HEIGHT:0.1\n");
  ASSERT_NE(own, std::string::npos);
  const size_t back = gcode.find("\n;HEIGHT:0.2\n", own);
  ASSERT_NE(back, std::string::npos) << "the next copy is told nothing of it";
  EXPECT_LT(back, gcode.find("G1 X60 Y10"));
  EXPECT_EQ(gcode.find(";HEIGHT:", back + 2), std::string::npos);
  const double area = std::numbers::pi / 4 * 1.75 * 1.75;
  const double length = 80 + std::hypot(16, 16);
  EXPECT_NEAR(Print(gcode).filament_mm * area,
              length * (SectionMm2(450'000, 200'000) + SectionMm2(450'000, 100'000)), 6e-5);
}

TEST(ProgramLayer, CoolingCountsAllCopies) {
  MotionOptions options = Options();
  options.tool().cooling.enabled = true;
  options.tool().cooling.slowdown_below_layer_time_s = 8;
  const LayerProgram two = Programmed(TwoSquares(), options);
  EXPECT_NEAR(two.stats.TimeS(), 8, 0.03);
  EXPECT_GT(Print(two.gcode).least_feed_rate,
            Print(Programmed(Square(), options).gcode).least_feed_rate);
}

TEST(ProgramLayer, MeetsOtherLayersReady) {
  OrderedLayer layer = Square();
  layer.blocks[0].travels = {{true, {}}, {true, {}}};
  layer.blocks[0].exit_travel = {{FromMm(11), FromMm(11)}, {true, {}}};
  layer.begins_ready = layer.ends_ready = true;
  const LayerProgram ready = Programmed(layer);
  EXPECT_EQ(ready.stats.retractions, 0);
  EXPECT_THAT(ready.gcode, Not(HasSubstr("E-")));
  EXPECT_EQ(ready.exit, (Point{FromMm(11), FromMm(11)}));
  layer.begins_ready = false;
  EXPECT_EQ(Programmed(layer).stats.retractions, 0);
  EXPECT_THAT(Programmed(layer).gcode, HasSubstr("E.8"));
  layer.ends_ready = false;
  EXPECT_EQ(Programmed(layer).stats.retractions, 1);
  EXPECT_EQ(Programmed(layer).exit, (Point{FromMm(28), FromMm(28)}));
}

TEST(ProgramLayer, AnEmptyLayerHandsTheFilamentOnAsItShould) {
  OrderedLayer layer;
  layer.frame = {2, 600'000, 200'000};
  EXPECT_THAT(Programmed(layer).gcode, Not(HasSubstr("G1")));
  layer.begins_ready = true;
  EXPECT_THAT(Programmed(layer).gcode, HasSubstr("E-.8"));
  layer.ends_ready = true;
  EXPECT_THAT(Programmed(layer).gcode, HasSubstr("E-.8")) << "the layer above may begin far away";
  EXPECT_TRUE(Programmed(layer).ends_retracted);
}

TEST(ProgramLayer, TellsWhatTheLayerBelowMayHaveDone) {
  for (const bool absolute : {true, false}) {
    for (const bool hidden : {true, false}) {
      MotionOptions options = Options();
      options.writing.relative_e = !absolute;
      OrderedLayer layer = Square();
      layer.blocks[0].travels = {{hidden, {}}, {true, {}}};
      layer.blocks[0].exit_travel = {{FromMm(11), FromMm(11)}, {}};
      layer.begins_ready = layer.ends_ready = true;
      const LayerProgram program = Programmed(layer, options);
      const auto line =
          std::ranges::find(program.mode_lines, MachineMode::kFilament, &ModeLine::mode);
      ASSERT_NE(line, program.mode_lines.end());
      EXPECT_EQ(line->value, hidden ? kReady : kRetracted);
      const std::string text =
          program.gcode.substr(static_cast<size_t>(line->at), static_cast<size_t>(line->size));
      EXPECT_EQ(text, absl::StrCat(hidden ? "G1 E.8 F2100\n" : "G1 E-.8 F2100\n",
                                   absolute ? "G92 E0\n" : ""));
      // The following lines do not depend on the feed rate of this line.
      const auto end = static_cast<size_t>(line->at + line->size);
      EXPECT_THAT(program.gcode.substr(end, program.gcode.find('\n', end) - end),
                  HasSubstr(hidden ? ";TYPE" : " F"));
      EXPECT_TRUE(program.ends_retracted);
    }
  }
}

TEST(ProgramLayer, SupportsBetweenThePartsLayersAreNotSlowedDown) {
  MotionOptions options = Options();
  options.tool().cooling.enabled = true;
  options.tool().cooling.slowdown_below_layer_time_s = 8;
  OrderedLayer layer = Square();
  layer.blocks[0].stack = Stack(1, 0, StackKind::kSupport);
  EXPECT_LT(Programmed(layer, options).stats.TimeS(), 4);
  layer.blocks.push_back(Square().blocks[0]);
  layer.visits.push_back({1, 0, 0, {}});
  EXPECT_NEAR(Programmed(layer, options).stats.TimeS(), 8, 0.03) << "with the part";
}

/// Returns a turn of a spiral along a square. It begins where the turn below ended.
OrderedLayer Turn() {
  OrderedLayer layer = Square();
  layer.blocks[0].paths.pop_back();
  const Point start = layer.blocks[0].paths[0].points[0];
  layer.blocks[0].spiral = {.start = start, .from = start, .last = false, .blends = false};
  layer.begins_ready = layer.ends_ready = true;
  return layer;
}

TEST(ProgramLayer, ATurnOfASpiralRisesAlongItsWay) {
  const LayerProgram turn = Programmed(Turn());
  EXPECT_EQ(turn.stats.retractions, 0);
  for (const char* move : {"G1 X30 Y10 Z.45 ", "G1 Y30 Z.5 ", "G1 X10 Z.55 ", "G1 Y10 Z.6 "})
    EXPECT_THAT(turn.gcode, HasSubstr(move));
  EXPECT_THAT(turn.gcode, Not(HasSubstr("G1 Z")));
}

TEST(ProgramLayer, TheFirstAndTheLastTurnThinOut) {
  const double whole = Programmed(Turn()).stats.FilamentMm();
  OrderedLayer first = Turn();
  first.begins_ready = false;
  first.blocks[0].spiral->from.reset();
  EXPECT_NEAR(Programmed(first).stats.FilamentMm(), whole / 2, whole / 100);
  OrderedLayer last = Turn();
  last.ends_ready = false;
  last.blocks[0].spiral->last = true;
  EXPECT_NEAR(Programmed(last).stats.FilamentMm(), whole * 3 / 2, whole / 100);
}

TEST(ProgramLayer, ATurnIsTheFirstOfEachPass) {
  OrderedLayer layer = Turn();
  layer.visits.push_back({0, 1, 1, {FromMm(50), 0}});
  const auto passes = Passes(layer);
  ASSERT_EQ(passes.size(), 2u);
  for (const LayerProgram& pass : passes) EXPECT_EQ(pass.stats.retractions, 0);
}

}  // namespace
}  // namespace slicefarm::motion::layer_program_test
