#include "common/config/presets/overlay_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace slicefarm::config::presets::overlay_names_test {
namespace {

TEST(OverlayName, CanBeTypedAndHasOnlyTheCharactersOfProfiles) {
  EXPECT_EQ(OverlayName("Prusa MK4 0.4 nozzle"), "overlay.Prusa_MK4_0.4_nozzle");
  EXPECT_EQ(OverlayName("A1", "Generic PLA @BBL"), "overlay.A1__with__Generic_PLA___40BBL");
  EXPECT_EQ(OverlayName("\xc3\xa9"), "overlay.__C3__A9");
}

TEST(OverlayName, DifferentPresetsHaveDifferentNames) {
  const char* const parts[] = {"",    "A",    "A B",      "A_B",    "A  B",  "A 20B",  "A __20B",
                               "A_",  "A ",   "A  ",      "A _",    "A__5F", "A@",     "a",
                               "A.B", "with", "A with B", "_with_", "__",    " with ", "A-B"};
  std::set<std::string> names;
  size_t count = 0;
  for (const char* printer : parts)
    for (const char* filament : parts) {
      if (*printer == '\0') continue;
      ++count;
      EXPECT_TRUE(names.insert(OverlayName(printer, filament)).second)
          << printer << " | " << filament;
    }
  EXPECT_EQ(names.size(), count);
}

TEST(OverlayNames, TheFilamentOverridesThePrinter) {
  EXPECT_THAT(OverlayNames("P", "F"), testing::ElementsAre("overlay.P", "overlay.P__with__F"));
}

}  // namespace
}  // namespace slicefarm::config::presets::overlay_names_test
