#include "common/config/projects/orca_gcode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "common/model/limits.h"

namespace slicefarm::config::orca_gcode_test {
namespace {

using Given = std::map<std::string, std::string, std::less<>>;

/// Returns `setting: lines` of each addition.
std::vector<std::string> Added(const Given& given) {
  std::vector<std::string> lines;
  for (const AddedGcode& added : AddedGcodeOf([&](std::string_view key) {
         const auto found = given.find(key);
         return found == given.end() ? std::nullopt : std::optional(found->second);
       }))
    lines.push_back(std::string(added.key) + ": " + added.lines);
  return lines;
}

TEST(AddedGcodeOf, ExhaustFan) {
  const Given off = {{"during_print_exhaust_fan_speed", "70"}};
  EXPECT_TRUE(Added(off).empty());
  const Given on = {{"activate_air_filtration", "1"},
                    {"during_print_exhaust_fan_speed", "70"},
                    {"complete_print_exhaust_fan_speed", "100"}};
  EXPECT_EQ(Added(on), (std::vector<std::string>{"start_gcode: M106 P3 S178\\n",
                                                 "end_gcode: M106 P3 S255\\n"}));
  EXPECT_EQ(
      Added({{"activate_air_filtration", "1"}}),
      (std::vector<std::string>{"start_gcode: M106 P3 S153\\n", "end_gcode: M106 P3 S204\\n"}));
}

TEST(AddedGcodeOf, ExhaustFanDuringOrAfterThePrint) {
  EXPECT_EQ(
      Added({{"activate_air_filtration", "1"}, {"activate_air_filtration_during_print", "0"}}),
      std::vector<std::string>{"end_gcode: M106 P3 S204\\n"});
  EXPECT_EQ(
      Added({{"activate_air_filtration", "1"}, {"activate_air_filtration_on_completion", "0"}}),
      std::vector<std::string>{"start_gcode: M106 P3 S153\\n"});
}

TEST(AddedGcodeOf, AuxiliaryFanRisesToItsSpeed) {
  const Given fan = {{"auxiliary_fan", "1"},
                     {"additional_cooling_fan_speed", "80"},
                     {"first_x_layer_fan_speed", "20"},
                     {"close_additional_fan_first_x_layers", "2"},
                     {"additional_fan_full_speed_layer", "5"}};
  EXPECT_EQ(Added(fan).front(),
            "layer_gcode: {if layer_num==0}M106 P2 S51\\n{endif}"
            "{if layer_num==2}M106 P2 S102\\n{endif}{if layer_num==3}M106 P2 S153\\n{endif}"
            "{if layer_num==4}M106 P2 S204\\n{endif}");
}

TEST(AddedGcodeOf, AuxiliaryFanRisesOverNoMoreLayersThanAJobMayHave) {
  const auto lines = Added({{"auxiliary_fan", "1"},
                            {"additional_cooling_fan_speed", "80"},
                            {"additional_fan_full_speed_layer", "1e18"}});
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(std::ranges::count(lines.front(), 'S'), limits::kMaxLayers) << "commands M106 P2 S";
}

TEST(AddedGcodeOf, InputShapers) {
  const auto lines = [](std::string_view flavor, std::string_view type) {
    return Added({{"input_shaping_emit", "1"},
                  {"gcode_flavor", std::string(flavor)},
                  {"input_shaping_type", std::string(type)},
                  {"input_shaping_freq_x", "45.5"},
                  {"input_shaping_freq_y", "0"},
                  {"input_shaping_damp_x", "0.1"},
                  {"input_shaping_damp_y", "0"}});
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines("klipper", "MZV"),
            Lines{"start_gcode: SET_INPUT_SHAPER SHAPER_TYPE_X=mzv SHAPER_FREQ_X=45.5 "
                  "DAMPING_RATIO_X=0.1\\nSET_INPUT_SHAPER SHAPER_TYPE_Y=mzv\\n"});
  EXPECT_EQ(lines("klipper", "Disable"), Lines{"start_gcode: SET_INPUT_SHAPER SHAPER_FREQ_X=0\\n"
                                               "SET_INPUT_SHAPER SHAPER_FREQ_Y=0\\n"});
  EXPECT_EQ(lines("marlin2", "ZV"), Lines{"start_gcode: M593 X F45.5 D0.1\\n"});
  EXPECT_EQ(lines("reprapfirmware", "EI2"), Lines{"start_gcode: M593 P\"ei2\" F45.5 S0.1\\n"});
  EXPECT_EQ(lines("marlin", "ZV"), Lines{}) << "Marlin 1 has no input shapers";
  EXPECT_EQ(Added({{"input_shaping_freq_x", "45"}, {"gcode_flavor", "klipper"}}), Lines{});
}

TEST(AddedGcodeOf, PowerLossRecovery) {
  using Lines = std::vector<std::string>;
  const auto lines = [](std::string_view mode, std::string_view flavor, std::string_view model) {
    return Added({{"enable_power_loss_recovery", std::string(mode)},
                  {"gcode_flavor", std::string(flavor)},
                  {"printer_model", std::string(model)}});
  };
  EXPECT_EQ(lines("enable", "marlin2", "X"), Lines{"start_gcode: M413 S1\\n"});
  EXPECT_EQ(lines("disable", "marlin2", "X"), Lines{"start_gcode: M413 S0\\n"});
  EXPECT_EQ(lines("printer_configuration", "marlin2", "X"), Lines{});
  EXPECT_EQ(lines("enable", "klipper", "X"), Lines{});
  EXPECT_EQ(lines("disable", "marlin", "Bambu Lab P1S"),
            Lines{"layer_gcode: {if layer_num==1}M1003 S0\\n{endif}"});
}

TEST(AddedGcodeOf, ScanOnlyOnMachinesWithAScanner) {
  const Given scan = {{"scan_first_layer", "1"}, {"printer_model", "Bambu Lab X1 Carbon"}};
  ASSERT_EQ(Added(scan).size(), 1u);
  EXPECT_TRUE(Added(scan).front().starts_with("layer_gcode: {if layer_num==1}M976 S1 P1"));
  EXPECT_TRUE(Added({{"scan_first_layer", "1"}, {"printer_model", "Voron 2.4"}}).empty());
}

TEST(WithGcode, JoinsLines) {
  const AddedGcode last = {.key = "layer_gcode", .lines = "M1\\n"};
  EXPECT_EQ(WithGcode("", last), "M1\\n");
  EXPECT_EQ(WithGcode("M0", last), "M0\\nM1\\n");
  EXPECT_EQ(WithGcode("M0\\n", last), "M0\\nM1\\n");
  const AddedGcode first = {.key = "end_gcode", .lines = "M1\\n", .in_front = true};
  EXPECT_EQ(WithGcode("M0", first), "M1\\nM0");
}

}  // namespace
}  // namespace slicefarm::config::orca_gcode_test
