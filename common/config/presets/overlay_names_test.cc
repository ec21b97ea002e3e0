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

TEST(WithOverlays, TheOverlaysThatExistComeFirst) {
  const PresetNames presets = {"P", "Q", "F"};
  const auto all = [](const std::string& name) -> absl::StatusOr<int64_t> {
    return name == "overlay.P" ? 3 : 5;
  };
  const auto none = [](const std::string&) -> absl::StatusOr<int64_t> {
    return absl::NotFoundError("no");
  };
  const auto fails = [](const std::string&) -> absl::StatusOr<int64_t> {
    return absl::UnavailableError("no");
  };
  EXPECT_THAT(*WithOverlays(presets, {"mine@1"}, all),
              testing::ElementsAre("overlay.P@3", "overlay.P__with__F@5", "mine@1"));
  EXPECT_THAT(*WithOverlays(presets, {"overlay.P@1", "mine"}, all),
              testing::ElementsAre("overlay.P__with__F@5", "overlay.P@1", "mine"));
  EXPECT_THAT(*WithOverlays(presets, {"overlay.P", "overlay.P__with__F@2"}, fails),
              testing::ElementsAre("overlay.P", "overlay.P__with__F@2"));
  EXPECT_THAT(*WithOverlays(presets, {"mine"}, none), testing::ElementsAre("mine"));
  EXPECT_TRUE(absl::IsUnavailable(WithOverlays(presets, {}, fails).status()));
}

}  // namespace
}  // namespace slicefarm::config::presets::overlay_names_test
