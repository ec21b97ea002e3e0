#include "common/config/presets/portable_settings.h"

#include <gtest/gtest.h>

namespace slicefarm::config::presets::portable_settings_test {
namespace {

/// Change from a printer with a nozzle of 0.4 mm to one with 0.6 mm and layers of 0.12 to 0.45 mm.
constexpr PrinterChange kWiderNozzle = {0.4, 0.6, 0.12, 0.45, true};

struct Case {
  std::string name;
  PresetKind kind;
  Setting setting;
  std::string why;  ///< empty: the setting fits
};

class WhyUnfitTest : public testing::TestWithParam<Case> {};

TEST_P(WhyUnfitTest, NamesTheReason) {
  EXPECT_EQ(WhyUnfit(GetParam().kind, GetParam().setting, kWiderNozzle), GetParam().why);
}

constexpr auto kProcess = PresetKind::kProcess;
constexpr auto kFilament = PresetKind::kFilament;

INSTANTIATE_TEST_SUITE_P(
    Settings, WhyUnfitTest,
    testing::Values(
        Case{"Walls", kProcess, {"wall_loops", "4"}, ""},
        Case{"Speed", kProcess, {"outer_wall_speed", "40"}, ""},
        Case{"Host", kProcess, {"exclude_object", "1"}, "belongs to the printer"},
        Case{"WidthInMm", kProcess, {"line_width", "0.42"}, "is for a nozzle of 0.4 mm"},
        Case{"WidthInPercent", kProcess, {"line_width", "105%"}, ""},
        Case{"AutomaticWidth", kProcess, {"extrusion_width", "0"}, ""},
        Case{"Height", kProcess, {"layer_height", "0.3"}, ""},
        Case{"HighestLayer", kProcess, {"layer_height", "0.45"}, ""},
        Case{"TooHigh",
             kProcess,
             {"layer_height", "0.5"},
             "layers of 0.5 mm are higher than the printer's largest layer height of 0.45 mm"},
        Case{"TooLow",
             kProcess,
             {"first_layer_height", "0.1"},
             "layers of 0.1 mm are lower than the printer's smallest layer height of 0.12 mm"},
        Case{"HeightInPercent", kProcess, {"first_layer_height", "150%"}, ""},
        Case{"VariableHeights", kProcess, {"layer_height_profile", "0;0.2;5;0.3"}, ""},
        Case{"VariableHeightsTooLow",
             kProcess,
             {"layer_height_profile", "0;0.2;0.05;0.08"},
             "layers of 0.08 mm are lower than the printer's smallest layer height of 0.12 mm"},
        Case{"Cooling", kFilament, {"fan_max_speed", R"(["40"])"}, ""},
        Case{"Temperature",
             kFilament,
             {"nozzle_temperature", R"(["230"])"},
             "belongs to the printer's filament"},
        Case{"PressureAdvance",
             kFilament,
             {"pressure_advance", R"(["0.03"])"},
             "belongs to the printer's filament"},
        Case{"Machine",
             PresetKind::kPrinter,
             {"machine_start_gcode", "G28"},
             "belongs to the printer"}),
    [](const auto& info) { return info.param.name; });

TEST(WhyUnfit, CoolingIsOfOneMaterial) {
  PrinterChange change = kWiderNozzle;
  change.same_material = false;
  EXPECT_EQ(WhyUnfit(kFilament, {"fan_max_speed", "100"}, change), "is for another material");
}

TEST(WhyUnfit, WidthsFitAnEqualNozzle) {
  PrinterChange change = kWiderNozzle;
  change.to_nozzle_mm = 0.4;
  EXPECT_EQ(WhyUnfit(kProcess, {"line_width", "0.5"}, change), "");
  change.from_nozzle_mm = 0;
  EXPECT_NE(WhyUnfit(kProcess, {"line_width", "0.5"}, change), "") << "the former one is unknown";
}

TEST(DescribesPart, IsTrueForShellsAndFalseForMoves) {
  for (const char* key : {"wall_loops", "sparse_infill_pattern", "enable_support", "brim_type",
                          "layer_height", "seam_position", "ironing_type"})
    EXPECT_TRUE(DescribesPart(PresetDialect::kOrca, key)) << key;
  for (const char* key :
       {"perimeters", "fill_pattern", "support_material", "brim_width", "raft_layers"})
    EXPECT_TRUE(DescribesPart(PresetDialect::kPrusa, key)) << key;
  for (const char* key :
       {"outer_wall_speed", "default_acceleration", "line_width", "nozzle_diameter",
        "machine_start_gcode", "filename_format", "no_such_key", "fan_max_speed"})
    EXPECT_FALSE(DescribesPart(PresetDialect::kOrca, key)) << key;
}

}  // namespace
}  // namespace slicefarm::config::presets::portable_settings_test
