#include "services/motion/algo/program/print_clock.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "common/base/text.h"
#include "common/model/options/motion_options.h"
#include "common/model/paths_test.h"
#include "services/motion/algo/layer_program.h"
#include "services/motion/algo/program/program_time.h"
#include "services/motion/algo/program_envelope.h"

namespace slicefarm::motion::print_clock_test {
namespace {

Path Line(Feature feature, std::string_view points, bool closed = false) {
  Path path = MakePathOrDie(points, closed);
  path.feature = feature;
  return path;
}

/// Returns walls and fill of two copies, at other places in each layer.
OrderedLayer Layer(int32_t index) {
  OrderedLayer layer;
  layer.frame = {index, (index + 1) * 200'000, 200'000};
  layer.blocks = {{0,
                   index,
                   layer.frame.height_nm,
                   {Line(Feature::kExternalPerimeter, "(10 10, 30 10, 30 30, 10 30)", true),
                    Line(Feature::kInternalInfill, "(12 12, 28 28)"),
                    Line(Feature::kSolidInfill, "(28.5 28, 29 28, 29 28.5, 20 29)")}}};
  const Point shift = {FromMm(7 * index), FromMm(3)};
  layer.visits = {{0, 0, 0, shift}, {0, 1, 0, shift + Point{FromMm(50), 0}}};
  return layer;
}

struct Case {
  std::string_view name;
  GcodeFlavor flavor = GcodeFlavor::kKlipper;
  double lift_mm = 0;
  double retraction_mm = 0.8;
  double travel_acceleration_mm_s2 = 0;
  bool written = true;
  double tolerance_s = 1e-6;  ///< tolerance of each sum
};

MotionOptions Options(const Case& c) {
  MotionOptions options;
  options.flavor = c.flavor;
  options.tool().retraction.length_mm = c.retraction_mm;
  options.tool().retraction.lift_mm = c.lift_mm;
  options.travel_acceleration_mm_s2 = c.travel_acceleration_mm_s2;
  if (c.written) {
    options.default_acceleration_mm_s2 = 1000;
    options.acceleration_mm_s2[static_cast<size_t>(Feature::kExternalPerimeter)] = 600;
    options.acceleration_mm_s2[static_cast<size_t>(Feature::kSolidInfill)] = 2500;
    options.first_layer_acceleration_mm_s2 = 500;
  }
  options.start_gcode = "G28\nG1 Z5 F1200\nG1 X0 Y-3 F3000\nG1 X60 E9 F1000\nG4 P200";
  options.end_gcode = "G1 X0 Y200\nG1 E-2 F300";
  return options;
}

class PrintClockTest : public testing::TestWithParam<Case> {};

// The time computed from separate layers is the time of the program as a whole.
TEST_P(PrintClockTest, IsTheTimeOfTheWholeProgram) {
  const MotionOptions options = Options(GetParam());
  ProgramSummary summary;
  std::vector<LayerProgram> programs;
  for (int32_t i = 0; i < 5; ++i) {
    auto passes = ProgramLayer(Layer(i), {}, options, *LayerCode::Of(options));
    ASSERT_TRUE(passes.ok()) << passes.status();
    LayerProgram& program = programs.emplace_back(std::move(passes->front()));
    summary.layers.push_back({.frame = program.frame,
                              .entry = program.entry,
                              .exit = program.exit,
                              .time_s = program.stats.TimeS(),
                              .edges = program.edges});
    summary.total.Add(program.stats);
  }
  const auto frame = FrameProgram(summary, options);
  ASSERT_TRUE(frame.ok()) << frame.status();
  std::string gcode = frame->prologue;
  for (size_t i = 0; i < programs.size(); ++i)
    gcode += frame->layer_prefixes[i] + programs[i].gcode;
  gcode += frame->epilogue;

  const ProgramTime want = TimeOfProgram(gcode, FirmwareOf(options.flavor),
                                         {options.limits, options.tool().retraction, {}});
  const PrintTimes& got = frame->times;
  const double tolerance = GetParam().tolerance_s;
  EXPECT_NEAR(got.TotalS(), want.TotalS(), tolerance);
  EXPECT_NEAR(got.travel_s, want.travel_s, tolerance);
  EXPECT_NEAR(got.retract_s, want.retract_s, tolerance);
  EXPECT_EQ(got.dwell_s, 0.2);
  EXPECT_EQ(got.homings, 1);
  EXPECT_EQ(got.heat_waits, 1);
  for (const Feature feature :
       {Feature::kExternalPerimeter, Feature::kInternalInfill, Feature::kSolidInfill}) {
    EXPECT_NEAR(got.feature_s[static_cast<size_t>(feature)],
                want.feature_s.at(std::string(FeatureName(feature))), tolerance);
  }
  ASSERT_EQ(got.layer_s.size(), want.layer_s.size());
  for (size_t i = 0; i + 1 < want.layer_s.size(); ++i)
    EXPECT_NEAR(got.layer_s[i], want.layer_s[i], tolerance) << i;
  EXPECT_NEAR(got.before_s, want.before_s, tolerance);
}

/// Returns the time of the lines between the labels of a copy.
double TimeBetweenLabels(const std::string& gcode, const ProgramTime& time, int copy) {
  const std::string begin = fmt::format("; printing object a id:0 copy {}", copy);
  double sum_s = 0, before_s = 0;
  bool within = false;
  size_t line = 0;
  for (const std::string_view text : Split(gcode, "\n")) {
    if (line >= time.line_end_s.size()) break;
    if (text == begin) within = true;
    if (text.starts_with("; stop printing object")) within = false;
    if (within) sum_s += time.line_end_s[line] - before_s;
    before_s = time.line_end_s[line++];
  }
  return sum_s;
}

// The copies are printed in turn, so the travels to them belong to none of them.
TEST_P(PrintClockTest, KnowsTheTimeOfEachCopy) {
  MotionOptions options = Options(GetParam());
  options.labels = ObjectLabels::kComments;
  JobFacts facts;
  facts.copies = {{"a", 0, 0, 2}, {"a", 0, 1, 2}};
  ProgramSummary summary;
  summary.copies = {{facts.copies[0], {}, {}}, {facts.copies[1], {}, {}}};
  std::vector<LayerProgram> programs;
  for (int32_t i = 0; i < 5; ++i) {
    auto passes = ProgramLayer(Layer(i), facts, options, *LayerCode::Of(options));
    ASSERT_TRUE(passes.ok()) << passes.status();
    LayerProgram& program = programs.emplace_back(std::move(passes->front()));
    summary.layers.push_back({.frame = program.frame,
                              .entry = program.entry,
                              .exit = program.exit,
                              .time_s = program.stats.TimeS(),
                              .edges = program.edges});
    summary.total.Add(program.stats);
    ASSERT_EQ(program.copies.size(), 2u);
    EXPECT_EQ(program.copies[0].use.filament_mm, program.copies[1].use.filament_mm);
    EXPECT_NEAR(2 * program.copies[0].use.filament_mm, program.stats.FilamentMm(), 1e-9);
    for (const CopyUse& copy : program.copies)
      summary.copies[static_cast<size_t>(copy.copy)].use.Add(copy.use);
  }
  const auto frame = FrameProgram(summary, options);
  ASSERT_TRUE(frame.ok()) << frame.status();
  std::string gcode = frame->prologue;
  for (size_t i = 0; i < programs.size(); ++i)
    gcode += frame->layer_prefixes[i] + programs[i].gcode;
  gcode += frame->epilogue;
  const ProgramTime time = TimeOfProgram(gcode, FirmwareOf(options.flavor),
                                         {options.limits, options.tool().retraction, {}});
  ASSERT_EQ(frame->times.copy_s.size(), 2u);
  double sum_s = 0;
  for (const int copy : {0, 1}) {
    const double got_s = frame->times.copy_s[static_cast<size_t>(copy)];
    EXPECT_GT(got_s, 1);
    EXPECT_NEAR(got_s, TimeBetweenLabels(gcode, time, copy), 10 * GetParam().tolerance_s) << copy;
    sum_s += got_s;
  }
  EXPECT_LT(sum_s, frame->times.TotalS());
}

INSTANTIATE_TEST_SUITE_P(
    Motion, PrintClockTest,
    testing::Values(
        Case{.name = "Klipper"}, Case{.name = "KlipperLifts", .lift_mm = 0.4},
        Case{.name = "KlipperTravels", .lift_mm = 0.2, .travel_acceleration_mm_s2 = 2000},
        Case{.name = "KlipperWithoutRetraction", .retraction_mm = 0, .tolerance_s = 1e-3},
        Case{.name = "KlipperUntold", .written = false},
        Case{.name = "RepRap", .flavor = GcodeFlavor::kRepRapFirmware, .lift_mm = 0.3},
        // The machine never stops between layers.
        Case{.name = "Marlin2", .flavor = GcodeFlavor::kMarlin2, .tolerance_s = 2e-3},
        Case{.name = "Marlin1",
             .flavor = GcodeFlavor::kMarlinLegacy,
             .lift_mm = 0.2,
             .tolerance_s = 2e-3}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace slicefarm::motion::print_clock_test
