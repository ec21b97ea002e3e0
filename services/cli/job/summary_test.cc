#include "services/cli/job/summary.h"

#include <gtest/gtest.h>

namespace slicefarm::cli::summary_test {
namespace {

TEST(SummaryText, SaysWhatMatters) {
  EXPECT_EQ(SummaryText({.output = "a.gcode",
                         .layers = 240,
                         .print_time_s = 3957,
                         .filament_mm = 4530,
                         .filament_g = 13.51}),
            "a.gcode: 240 layers, 1h 5m 57s to print, 4.53 m of filament (13.5 g)\n");
  EXPECT_EQ(SummaryText({.layers = 1,
                         .print_time_s = 5,
                         .filament_mm = 10,
                         .cached = true,
                         .settings_without_effect = 3}),
            "1 layer, 5s to print, 0.01 m of filament; from the cache\n"
            "3 of the given settings have no effect; --report FILE.json lists these settings\n");
  EXPECT_EQ(SummaryText({.layers = 1, .settings_without_effect = 54, .beside_print = 52}),
            "1 layer, 0s to print\n"
            "2 of the given settings have no effect (52 other settings without effect do not "
            "matter to this print); "
            "--report FILE.json lists these settings\n");
  EXPECT_EQ(SummaryText({.layers = 1,
                         .settings_without_effect = 7,
                         .changing = {"a = 1: not yet", "b = 2: x", "c = 3: y", "d = 4: z"},
                         .beside_print = 2}),
            "1 layer, 0s to print\n"
            "5 of the given settings have no effect, such as a = 1, b = 2, c = 3 and 1 more, "
            "which change the print (2 other settings without effect do not matter to this print); "
            "--report FILE.json "
            "lists these settings\n");
  EXPECT_EQ(SummaryText({.layers = 1, .job = "0123"}), "1 layer, 0s to print; job 0123\n");
  EXPECT_EQ(SummaryText({.layers = 1, .settings_without_effect = 52, .beside_print = 52}),
            "1 layer, 0s to print\n");
  EXPECT_EQ(SummaryText({.words = {"step", "steps", "to mill"}, .layers = 3, .print_time_s = 60}),
            "3 steps, 1m 0s to mill\n");
  EXPECT_EQ(
      SummaryText({.output = "a", .layers = 2, .settings_without_effect = 1, .report = "r.json"}),
      "a: 2 layers, 0s to print\n"
      "1 of the given settings has no effect; listed in r.json\n");
}

}  // namespace
}  // namespace slicefarm::cli::summary_test
