#include "common/macro/setting_variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/macro/setting_types.h"
#include "common/macro/settings_text.h"
#include "common/macro/template_defaults.h"
#include "common/macro/template_run.h"

namespace slicefarm::macro::setting_variables_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TypeOfSetting, IsPrusaSlicers) {
  using Of = SettingType::Of;
  EXPECT_EQ(TypeOfSetting("layer_height"), (SettingType{Of::kNumber, false}));
  EXPECT_EQ(TypeOfSetting("temperature"), (SettingType{Of::kWhole, true}));
  EXPECT_EQ(TypeOfSetting("spiral_vase"), (SettingType{Of::kFlag, false}));
  EXPECT_EQ(TypeOfSetting("filament_notes"), (SettingType{Of::kText, true}));
  EXPECT_EQ(TypeOfSetting("bed_shape"), (SettingType{Of::kPoint, true}));
  EXPECT_EQ(TypeOfSetting("square_corner_velocity"), std::nullopt);
}

TEST(SettingVariable, HasItsType) {
  EXPECT_THAT(SettingVariable("layer_height", "1").items, ElementsAre(TemplateValue(1.0)));
  EXPECT_THAT(SettingVariable("temperature", "210,nil").items,
              ElementsAre(TemplateValue(int64_t{210}), TemplateValue(Nil{})));
  EXPECT_THAT(SettingVariable("spiral_vase", "1").items, ElementsAre(TemplateValue(true)));
  EXPECT_THAT(SettingVariable("fill_density", "15%").items, ElementsAre(TemplateValue(15.0)));
  EXPECT_THAT(SettingVariable("filament_notes", "\"a;b\";c").items,
              ElementsAre(TemplateValue(std::string("a;b")), TemplateValue(std::string("c"))));
  EXPECT_THAT(SettingVariable("filament_colour", "").items,
              ElementsAre(TemplateValue(std::string())));
  EXPECT_THAT(SettingVariable("temperature", "").items, IsEmpty());
}

// Names without a type in PrusaSlicer get the type that the value looks like.
TEST(SettingVariable, GuessesOthers) {
  EXPECT_THAT(SettingVariable("mine", "210").items, ElementsAre(TemplateValue(int64_t{210})));
  EXPECT_THAT(SettingVariable("mine", "0.45").items, ElementsAre(TemplateValue(0.45)));
  EXPECT_THAT(SettingVariable("mine", "210,0.5").items,
              ElementsAre(TemplateValue(int64_t{210}), TemplateValue(0.5)));
  EXPECT_THAT(SettingVariable("mine", "0x0,250x0").items,
              ElementsAre(TemplateValue(std::string("0x0,250x0"))));
  EXPECT_THAT(SettingVariable("mine", "1,").items, ElementsAre(TemplateValue(std::string("1,"))));
}

struct Case {
  std::string settings;
  std::string code;
  std::string want;
};

class SettingVariablesTest : public testing::TestWithParam<Case> {};

TEST_P(SettingVariablesTest, AreFilledIn) {
  TemplateVariables variables;
  AddSettingVariables(GetParam().settings, variables);
  const auto text = ExpandTemplate("start_gcode", GetParam().code, variables);
  ASSERT_TRUE(text.ok()) << text.status();
  EXPECT_EQ(*text, GetParam().want);
}

INSTANTIATE_TEST_SUITE_P(
    Codes, SettingVariablesTest,
    testing::Values(
        Case{"layer_height = 1\n", "{layer_height / 2} [layer_height]", "0.5 1"},
        Case{"fill_density = 15%\n", "{fill_density} [fill_density]", "15 15%"},
        Case{"spiral_vase = 1\n", "{spiral_vase} [spiral_vase]{if spiral_vase}y{endif}", "true 1y"},
        Case{"notes = \"a\\nb\"\n", "{notes}|[notes]", "a\nb|a\\nb"},
        Case{"perimeter_speed = 50\nexternal_perimeter_speed = 50%\n",
             "{external_perimeter_speed} [external_perimeter_speed]", "25 50%"},
        Case{"bed_shape = -10x0,200x0,200x180.5,oops,1x,x\n",
             "{print_bed_min[0]} {print_bed_max[1]} {print_bed_size[0]}", "-10 180.5 210"},
        Case{"", "{initial_tool}[current_extruder] {is_extruder_used[0]}{is_extruder_used[4]}",
             "00 truefalse"},
        Case{"extruder = 3\nnum_extruders = 5\n",
             "T[initial_tool] {is_extruder_used[0]} {is_extruder_used[2]} {num_extruders}",
             "T2 false true 5"},
        Case{"extruder = 3\nnozzle_diameter = 0.6\n",
             "T[initial_filament_id] {first_non_support_filaments[0]} [next_extruder_id] "
             "H[initial_no_support_hotend] {nozzle_diameter_at_nozzle_id[initial_nozzle_id]} "
             "{wipe_tower_center_pos_valid}",
             "T2 2 0 H-1 0.6 false"},
        Case{"creation_time = 2026-11-25T10:37:01Z\n", "{timestamp} {year} {month} {second}",
             "20261125-103701 2026 11 1"},
        Case{"filament_type = PETG;PLA\n", "{initial_filament_type} {size(filament_type)}",
             "PETG 2"},
        Case{"", "{is_nil(idle_temperature[0]) ? 150 : idle_temperature[0]} {zhop}", "150 0"},
        Case{"", "{is_nil(filament_retract_length[0])}{is_nil(filament_wipe)}", "truetrue"},
        Case{"filament_wipe = 1\n", "{is_nil(filament_wipe) ? 0 : filament_wipe[0]}", "true"},
        Case{"", "{210 + extruder_temperature_offset[initial_extruder]}", "210"},
        Case{"", "{if filament_abrasive[0]}y{else}n{endif}[printer_vendor]", "n"},
        Case{"", "{if timelapse_type == 0}M1{endif} {farthest_point_timelapse ? 0.0 : 0.4}",
             "M1 0.4"},
        Case{"", "{wipe_tower}{wipe_into_infill}[printer_notes]{filament_vendor[0]}",
             "falsefalse(Unknown)"}));

TEST(AddSettingVariables, ClockNeedsATime) {
  TemplateVariables variables;
  AddSettingVariables("", variables);
  EXPECT_FALSE(variables.contains("timestamp"));
}

// Templates may use each setting of PrusaSlicer, even if a job does not have it. The setting has a
// default here, or the effective settings always contain it (settings_table_test.cc).
TEST(TemplateDefaults, AreOfTheirTypes) {
  int typed = 0;
  for (const auto& [key, value] : SettingLines(TemplateDefaults())) {
    const auto type = TypeOfSetting(key);
    if (!type || type->of == SettingType::Of::kText || value.empty()) continue;
    const auto variable = SettingVariable(key, value);
    for (const TemplateValue& item : variable.items) {
      ++typed;
      EXPECT_TRUE(type->of == SettingType::Of::kChoice || type->of == SettingType::Of::kPoint ||
                  !std::holds_alternative<std::string>(item))
          << key;
    }
  }
  EXPECT_GT(typed, 0);
}

}  // namespace
}  // namespace slicefarm::macro::setting_variables_test
