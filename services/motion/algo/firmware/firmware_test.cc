#include "services/motion/algo/firmware/firmware.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::firmware_test {
namespace {

TEST(FirmwareOf, HasTheNameOfItsSetting) {
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kMarlin2).name(), "marlin2");
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kMarlinLegacy).name(), "marlin");
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kKlipper).name(), "klipper");
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kRepRapFirmware).name(), "reprapfirmware");
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kPrusaBuddy).name(), "prusabuddy");
  EXPECT_EQ(FirmwareOf(GcodeFlavor::kBambu).name(), "bambu");
}

TEST(FindFirmware, ByItsNames) {
  EXPECT_EQ(FindFirmware("klipper"), &FirmwareOf(GcodeFlavor::kKlipper));
  EXPECT_EQ(FindFirmware("marlin"), &FirmwareOf(GcodeFlavor::kMarlin2));
  EXPECT_EQ(FindFirmware("rrf")->name(), "reprapfirmware");
  EXPECT_EQ(FindFirmware("rrf"), FindFirmware("reprapfirmware"));
  EXPECT_EQ(FindFirmware("grbl")->name(), "grbl");
  for (const char* name : {"prusabuddy", "bambu", "jerk"})
    EXPECT_EQ(FindFirmware(name)->name(), name);
  EXPECT_EQ(FindFirmware("smoothie"), nullptr);
}

TEST(Firmware, JerkByFlavour) {
  const auto text = [](GcodeFlavor flavor) {
    GcodeText out;
    FirmwareOf(flavor).WriteJerk(std::array<double, 4>{9, 9, 0.4, 2.5}, out);
    return out.Take();
  };
  EXPECT_EQ(text(GcodeFlavor::kMarlin2), "M205 X9 Y9\n");
  EXPECT_EQ(text(GcodeFlavor::kMarlinLegacy), "M205 X9 Y9\n");
  EXPECT_EQ(text(GcodeFlavor::kPrusaBuddy), "M205 X9 Y9\n");
  EXPECT_EQ(text(GcodeFlavor::kRepRapFirmware), "M566 X540 Y540\n");
  EXPECT_EQ(text(GcodeFlavor::kBambu), "M205 X9 Y9 Z0.4 E2.5\n");
  EXPECT_EQ(text(GcodeFlavor::kKlipper), "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=9\n");
}

TEST(Firmware, ReadsTheJerkThatItWrites) {
  for (const GcodeFlavor flavor : {GcodeFlavor::kMarlin2, GcodeFlavor::kRepRapFirmware,
                                   GcodeFlavor::kBambu, GcodeFlavor::kKlipper}) {
    const Firmware& firmware = FirmwareOf(flavor);
    GcodeText out;
    firmware.WriteJerk(std::array<double, 4>{9, 9, 0.4, 2.5}, out);
    MachineLimits limits;
    const std::string text = out.Take();
    firmware.ApplyLimits(ParseGcodeLine(std::string_view(text).substr(0, text.find('\n'))), limits);
    const bool klipper = flavor == GcodeFlavor::kKlipper;
    EXPECT_EQ(klipper ? limits.square_corner_velocity_mm_s : limits.max_jerk_mm_s[0], 9)
        << firmware.name();
  }
}

}  // namespace
}  // namespace slicefarm::motion::firmware_test
