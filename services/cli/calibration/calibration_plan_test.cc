#include "services/cli/calibration/calibration_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "common/base/error.h"
#include "common/model/options/height_code.h"
#include "services/cli/calibration/calibration_shapes.h"
#include "services/cli/calibration/solid_builder.h"

namespace slicefarm::cli::calibration_plan_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kSettings =
    "gcode_flavor = klipper\nlayer_height = 0.2\nfirst_layer_height = 0.2\nnozzle_diameter = 0.4\n"
    "external_perimeter_extrusion_width = 0.45\ntemperature = 215\nextrusion_multiplier = 0.98\n"
    "machine_max_feedrate_x = 300,200\n";

CalibrationPlan PlanOrDie(CalibrationKind kind, std::string_view settings = kSettings) {
  const CalibrationInfo& info = InfoOfCalibration(kind);
  const auto levels = LevelsOf(info, {}, kind == CalibrationKind::kTemperature ? 215 : 0);
  EXPECT_TRUE(levels.ok()) << levels.status();
  auto plan = PlanCalibration(kind, *levels, settings);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return plan.ok() ? *std::move(plan) : CalibrationPlan();
}

std::string ValueOfSetting(const std::vector<Setting>& settings, std::string_view key) {
  std::string value;
  for (const Setting& setting : settings)
    if (setting.key == key) value = setting.value;
  return value;
}

TEST(Levels, GoFromTheStartToTheEnd) {
  const CalibrationInfo& temperature = InfoOfCalibration(CalibrationKind::kTemperature);
  EXPECT_THAT(*LevelsOf(temperature, {}, 215), ElementsAre(230, 225, 220, 215, 210, 205, 200));
  EXPECT_THAT(*LevelsOf(temperature, {200, 210, 4}, 0), ElementsAre(200, 204, 208));
  const auto steps = *LevelsOf(InfoOfCalibration(CalibrationKind::kPressureAdvance), {}, 0);
  EXPECT_EQ(steps.size(), 11u) << "0.1 is reached in spite of rounding";
}

TEST(Levels, WrongRangesAreErrors) {
  const CalibrationInfo& info = InfoOfCalibration(CalibrationKind::kTemperature);
  const GivenLevels cases[] = {{200, 220, 0},   {200, 220, -5}, {200, 200, 5},
                               {200, 900, 50},  {10, 200, 10},  {200, 220, 0.001},
                               {200, 201, 1e9}, {NAN, 220, 5},  {200, INFINITY, 5}};
  for (const GivenLevels& given : cases)
    EXPECT_EQ(DetailOf(LevelsOf(info, given, 0).status()).reason, Reason::kRequestMalformed)
        << *given.start << " " << *given.end << " " << *given.step;
}

TEST(Labels, AreShortAndHaveAShape) {
  for (const CalibrationInfo& info : CalibrationInfos())
    for (const double value : {info.start, info.end, 0.0, 12.3456}) {
      const std::string label = LabelOf(info, value);
      EXPECT_LE(label.size(), 7u) << label;
      EXPECT_EQ(label.find_first_not_of(kKnownCharacters), std::string::npos) << label;
    }
  const CalibrationInfo& flow = InfoOfCalibration(CalibrationKind::kFlow);
  EXPECT_EQ(LabelOf(flow, 5), "+5");
  EXPECT_EQ(LabelOf(flow, -0.0), "0");
}

TEST(Code, IsTheFirmwares) {
  struct Case {
    CalibrationKind kind;
    const char* flavor;
    const char* code;  ///< empty: the firmware has none
  };
  const Case cases[] = {
      {CalibrationKind::kTemperature, "bambu", "M104 S0.5"},
      {CalibrationKind::kPressureAdvance, "klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.5"},
      {CalibrationKind::kPressureAdvance, "marlin2", "M900 K0.5"},
      {CalibrationKind::kPressureAdvance, "prusabuddy", "M572 S0.5"},
      {CalibrationKind::kPressureAdvance, "reprapfirmware", "M572 D0 S0.5"},
      {CalibrationKind::kRetraction, "klipper", "SET_RETRACTION RETRACT_LENGTH=0.5"},
      {CalibrationKind::kRetraction, "marlin", "M207 S0.5"},
      {CalibrationKind::kRetraction, "bambu", ""},
      {CalibrationKind::kCornering, "reprapfirmware", "M566 X30 Y30"},
      {CalibrationKind::kCornering, "klipper", "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=0.5"},
      {CalibrationKind::kInputShaping, "klipper",
       "SET_INPUT_SHAPER SHAPER_FREQ_X=0.5 SHAPER_FREQ_Y=0.5"},
      {CalibrationKind::kInputShaping, "prusabuddy", ""},
      {CalibrationKind::kVfa, "klipper", ""},
  };
  for (const Case& c : cases) {
    const auto code = CodeOf(InfoOfCalibration(c.kind), c.flavor, 0.5);
    if (*c.code == '\0') {
      EXPECT_EQ(DetailOf(code.status()).reason, Reason::kNotSupported) << c.flavor;
    } else {
      ASSERT_TRUE(code.ok()) << code.status();
      EXPECT_EQ(*code, c.code);
    }
  }
}

TEST(CalibrationPlan, EachFloorBeginsWithItsCode) {
  for (const CalibrationKind kind :
       {CalibrationKind::kTemperature, CalibrationKind::kPressureAdvance,
        CalibrationKind::kRetraction, CalibrationKind::kCornering,
        CalibrationKind::kInputShaping}) {
    const CalibrationPlan plan = PlanOrDie(kind);
    const auto codes = ParseHeightCodes(ValueOfSetting(plan.settings, "custom_gcode_per_print_z"));
    ASSERT_TRUE(codes.ok()) << codes.status();
    ASSERT_EQ(codes->size(), plan.table.rows.size());
    EXPECT_LT((*codes)[0].print_z_nm, 200'000) << "the first layer";
    for (size_t i = 1; i < codes->size(); ++i) {
      const double from_mm = plan.table.rows[i].from_mm;
      EXPECT_NEAR(ToMm(static_cast<double>((*codes)[i].print_z_nm)), from_mm, 0.02);
      EXPECT_EQ(from_mm, plan.table.rows[i - 1].to_mm);
      EXPECT_NEAR(std::remainder(from_mm - 0.2, 0.2), 0, 1e-9) << "floors are whole layers";
    }
  }
}

TEST(CalibrationPlan, LinesStandInTheMiddleOfTheBed) {
  const std::string settings = std::string(kSettings) +
                               "bed_shape = -100x-50,200x-50,200x150,-100x150\n"
                               "filament_max_volumetric_speed = 3.6\n";
  for (const CalibrationMethod method : {CalibrationMethod::kLine, CalibrationMethod::kPattern}) {
    const auto plan =
        PlanCalibration(CalibrationKind::kPressureAdvance, {0, 0.02, 0.04}, settings, method);
    ASSERT_TRUE(plan.ok()) << plan.status();
    ASSERT_EQ(plan->parts.size(), 1u);
    EXPECT_EQ(plan->parts[0].middle, (Point{FromMm(50), FromMm(50)}));
    EXPECT_EQ(plan->table.rows.size(), 3u);
    const auto codes = ParseHeightCodes(ValueOfSetting(plan->settings, "custom_gcode_per_print_z"));
    ASSERT_TRUE(codes.ok()) << codes.status();
    EXPECT_THAT(codes->front().text, HasSubstr("SET_PRESSURE_ADVANCE ADVANCE=0.02\n"));
    EXPECT_THAT(codes->front().text, HasSubstr(" F2400")) << "3.6 mm3/s: 40 mm/s of 0.45 x 0.2 mm";
  }
}

TEST(CalibrationPlan, SoftFilamentsHaveASlowAndAFastSpeedToo) {
  const std::string settings = std::string(kSettings) + "filament_max_volumetric_speed = 1.2\n";
  const auto plan = PlanCalibration(CalibrationKind::kPressureAdvance, {0, 0.02}, settings,
                                    CalibrationMethod::kLine);
  ASSERT_TRUE(plan.ok()) << plan.status();
  const auto codes = ParseHeightCodes(ValueOfSetting(plan->settings, "custom_gcode_per_print_z"));
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_THAT(codes->front().text, HasSubstr(" F800")) << "1.2 mm3/s: 13.3 mm/s of 0.45 x 0.2 mm";
  EXPECT_THAT(codes->front().text, HasSubstr(" F400")) << "half of it";
}

TEST(CalibrationPlan, TheSlicerRetractsUnlessTheFirmwareDoes) {
  for (const bool by_firmware : {false, true}) {
    const std::string settings =
        std::string("layer_height = 0.2\ngcode_flavor = ") +
        (by_firmware ? "marlin\nuse_firmware_retraction = 1\n" : "bambu\n");
    const CalibrationPlan plan = PlanOrDie(CalibrationKind::kRetraction, settings);
    const auto codes = ParseHeightCodes(ValueOfSetting(plan.settings, "custom_gcode_per_print_z"));
    ASSERT_TRUE(codes.ok()) << codes.status();
    ASSERT_EQ(codes->size(), 11u);
    EXPECT_EQ((*codes)[2].text, by_firmware ? "M207 S0.4" : "0.4");
    EXPECT_EQ((*codes)[2].kind,
              by_firmware ? HeightCodeKind::kCustom : HeightCodeKind::kRetractLength);
  }
}

TEST(CalibrationPlan, SpeedsFollowTheHeight) {
  const CalibrationPlan plan = PlanOrDie(CalibrationKind::kVolumetricSpeed);
  ASSERT_EQ(plan.parts.size(), 1u);
  ASSERT_EQ(plan.parts[0].ranges.size(), 16u);
  const HeightRange& range = plan.parts[0].ranges[5];  // 10 mm3/s
  EXPECT_EQ(range.from_mm, plan.table.rows[5].from_mm);
  const double section = 0.2 * (0.45 - 0.2 * (1 - 3.14159265 / 4)) * 0.98;
  EXPECT_NEAR(std::stod(ValueOfSetting(range.settings, "external_perimeter_speed")), 10 / section,
              0.01);
  EXPECT_EQ(ValueOfSetting(plan.settings, "filament_max_volumetric_speed"), "0");
  const auto fast = PlanCalibration(CalibrationKind::kVfa, {100, 301}, kSettings);
  EXPECT_EQ(DetailOf(fast.status()).reason, Reason::kSettingOutOfRange);
  EXPECT_THAT(std::string(fast.status().message()), HasSubstr("machine_max_feedrate_x = 300"));
}

TEST(CalibrationPlan, EachPlateHasItsFlow) {
  const CalibrationPlan plan = PlanOrDie(CalibrationKind::kFlow);
  ASSERT_EQ(plan.parts.size(), 9u);
  EXPECT_EQ(plan.parts[0].name, "flow -20");
  EXPECT_EQ(ValueOfSetting(plan.parts[8].settings, "top_solid_infill_flow_ratio"), "1.2");
  EXPECT_NEAR(plan.table.rows[8].value, 0.98 * 1.2, 1e-12) << "of extrusion_multiplier";
  EXPECT_EQ(plan.table.kind, "flow");
  EXPECT_EQ(plan.table.setting, "extrusion_multiplier");
  EXPECT_EQ(plan.table.rows[8].label, "+20");
}

TEST(SolidBuilder, TrianglesFaceOutwards) {
  SolidBuilder solid;
  solid.AddBox({0, 0, 0}, {1, 2, 3});
  solid.AddPrism({{0, 0}, {2, 0}, {0, 2}}, 1, 5, 6);
  solid.AddPrism({{0, 0}, {2, 0}, {0, 2}}, 0, 5, 6);
  const std::string stl = solid.Stl();
  const size_t count = (stl.size() - 84) / 50;
  ASSERT_EQ(count, 12u + 8 + 8);
  double volume = 0;  // by the divergence theorem: below zero if faces are inside out
  for (size_t i = 0; i < count; ++i) {
    float v[9];
    std::memcpy(v, stl.data() + 84 + 50 * i + 12, sizeof(v));
    volume += (v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6]) +
               v[2] * (v[3] * v[7] - v[4] * v[6])) /
              6;
  }
  EXPECT_NEAR(volume, 6 + 2 + 2, 0.02) << "solids are shorter by some micrometres";
}

TEST(SolidBuilder, DigitsAreUnlike) {
  std::set<std::string> shapes;
  for (const char c : kKnownCharacters) {
    SolidBuilder solid;
    solid.AddTextOnFront(std::string(1, c), {0, 0, 0}, 5, 1);
    EXPECT_TRUE(shapes.insert(solid.Stl()).second) << c;
    EXPECT_GT(solid.Stl().size(), 84u) << c;
  }
  EXPECT_NEAR(TextWidth("10", 10) - TextWidth("1", 10), 7.8, 1e-5);
}

}  // namespace
}  // namespace slicefarm::cli::calibration_plan_test
