#include "services/cli/program/machine_config.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli::machine_config_test {
namespace {

TEST(SetupOfSettings, TakesWhatItSaysOfTheMachineAlone) {
  const auto setup = SetupOfSettings(
      "machine_max_acceleration_extruding = 1234,500\nbed_shape = 0x0,100x0,100x90,0x90\n"
      "layer_height = nonsense\nfilament_diameter = 2.85\n");
  ASSERT_TRUE(setup.ok()) << setup.status();
  EXPECT_EQ(setup->machine.limits.max_acceleration_extruding_mm_s2, 1234);
  EXPECT_EQ(setup->bed.size(), 4);
  EXPECT_EQ(setup->max_height_mm, 0) << "not said";
  EXPECT_EQ(setup->filament_mm, 2.85);
}

TEST(SetupOfSettings, TakesAnyNozzle) {
  for (const char* nozzle : {"0.05", "0.15", "0.25,0.4", "0.4", "1.8"}) {
    const auto setup = SetupOfSettings(std::string("nozzle_diameter = ") + nozzle + "\n");
    ASSERT_TRUE(setup.ok()) << setup.status();
    EXPECT_EQ(setup->nozzle_mm, std::stod(nozzle));
  }
}

TEST(SetupOfSettings, TakesThoseOfOrcaSlicer) {
  const auto setup = SetupOfSettings(
      ";LAYER_CHANGE\nG1 X1\n; printable_area = 0x0,256x0,256x256,0x256\n"
      "; machine_max_speed_x = 321,200\n"
      "; retraction_length = 1.5\n; nozzle_diameter = 0.2\n; printable_height = 250\n");
  ASSERT_TRUE(setup.ok()) << setup.status();
  EXPECT_EQ(setup->machine.limits.max_feedrate_mm_s[0], 321);
  EXPECT_EQ(setup->machine.retraction.length_mm, 1.5);
  EXPECT_EQ(setup->bed.size(), 4);
  EXPECT_EQ(setup->max_height_mm, 250);
}

TEST(ReadMachine, ByFileByTheGcodeByDefault) {
  const TempDirectory folder;
  const std::string path = folder.path() + "/printer.cfg";
  ASSERT_TRUE(WriteFile(path, "[printer]\nmax_velocity: 111\nmax_accel: 2222\n").ok());
  const std::string gcode =
      "G1 X1\n; prusaslicer_config = begin\n; machine_max_feedrate_x = 77\n"
      "; prusaslicer_config = end\n";
  const auto file = ReadMachine(path, gcode);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->setup.machine.limits.max_feedrate_mm_s[0], 111);
  const auto quoted = ReadMachine("", gcode);
  ASSERT_TRUE(quoted.ok()) << quoted.status();
  EXPECT_EQ(quoted->source, "gcode");
  EXPECT_EQ(quoted->setup.machine.limits.max_feedrate_mm_s[0], 77);
  const auto standard = ReadMachine("", "G1 X1\n");
  ASSERT_TRUE(standard.ok()) << standard.status();
  EXPECT_EQ(standard->source, "defaults");
  EXPECT_TRUE(standard->setup.bed.empty());
  EXPECT_EQ(DetailOf(ReadMachine(folder.path() + "/none", gcode).status()).reason,
            Reason::kRequestMalformed);
}

TEST(FirmwareNamedIn, IsTheOneOfTheQuotedSettings) {
  const std::pair<const char*, std::string_view> cases[] = {
      {"G1 X1\n; prusaslicer_config = begin\n; gcode_flavor = klipper\n", "klipper"},
      {"G1 X1\n; prusaslicer_config = begin\n; gcode_flavor = marlin2\n", "marlin"},
      {";LAYER_CHANGE\nG1 X1\n; gcode_flavor = marlin\n; machine_max_acceleration_x = 9000\n"
       "; printable_area = 0x0,256x0,256x256,0x256\n; printer_model = Bambu Lab A1\n",
       "bambu"}};
  for (const auto& [gcode, name] : cases) {
    const motion::Firmware* firmware = FirmwareNamedIn(gcode);
    ASSERT_NE(firmware, nullptr) << gcode;
    EXPECT_EQ(firmware, motion::FindFirmware(name)) << gcode;
  }
  for (const char* gcode : {"", "G1 X1\n", "; gcode_flavor = klipper\nG1 X1\n",
                            "\n; prusaslicer_config = begin\n; gcode_flavor = dancing\n"})
    EXPECT_EQ(FirmwareNamedIn(gcode), nullptr) << gcode;
}

}  // namespace
}  // namespace slicefarm::cli::machine_config_test
