#include "common/config/projects/orca_gcode.h"

#include <gtest/gtest.h>

#include <map>

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
