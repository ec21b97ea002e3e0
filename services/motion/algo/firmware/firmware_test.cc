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

}  // namespace
}  // namespace slicefarm::motion::firmware_test
