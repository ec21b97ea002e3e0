#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "common/config/table/settings_table.h"
#include "common/macro/setting_types.h"
#include "common/macro/settings_text.h"
#include "common/macro/template_defaults.h"

namespace slicefarm::config::template_types_test {
namespace {

using Of = macro::SettingType::Of;

/// Returns the type that templates give to settings of a kind, or nullopt if PrusaSlicer has no
/// setting of the kind.
std::optional<Of> TypeOf(Kind kind) {
  switch (kind) {
    case Kind::kFlag:
      return Of::kFlag;
    case Kind::kInteger:
      return Of::kWhole;
    case Kind::kNumber:
      return Of::kNumber;
    case Kind::kPercent:
      return Of::kPercent;
    case Kind::kNumberOrPercent:
      return Of::kNumberOrPercent;
    case Kind::kChoice:
      return Of::kChoice;
    case Kind::kText:
    case Kind::kGcode:
      return Of::kText;
    case Kind::kBedShape:
      return Of::kPoint;
    default:
      return std::nullopt;
  }
}

// A template computes with the value that the job uses, so both must read the text alike.
TEST(TemplateTypes, AreTheKindsOfTheTable) {
  int compared = 0;
  for (const SettingSpec& spec : SettingsTable(Process::kFdm)) {
    const auto type = macro::TypeOfSetting(spec.key);
    const auto expected = TypeOf(spec.kind);
    if (!type || !expected) continue;
    // PrusaSlicer has whole degrees; ours may have a fraction.
    if (spec.key == "support_material_threshold") continue;
    EXPECT_EQ(type->of, *expected) << spec.key;
    EXPECT_EQ(type->is_list, spec.list != List::kNone || spec.kind == Kind::kBedShape) << spec.key;
    ++compared;
  }
  EXPECT_GT(compared, 150);
}

// Stages have no value for these settings, so templates take the default if a job does not set
// them.
TEST(TemplateDefaults, AreThoseOfTheTable) {
  for (const std::string_view key :
       {"cooling_filter_enabled", "enable_wrapping_detection", "farthest_point_timelapse",
        "timelapse_type", "wrapping_detection_layers"}) {
    const SettingSpec& spec = SettingsTable(Process::kFdm)[FindSetting(key, Process::kFdm)];
    EXPECT_EQ(spec.field.set, nullptr) << key;
    const auto lines = macro::SettingLines(macro::TemplateDefaults());
    const auto line =
        std::ranges::find(lines, key, &std::pair<std::string_view, std::string_view>::first);
    ASSERT_NE(line, lines.end()) << key;
    EXPECT_EQ(line->second, spec.standard) << key;
  }
}

}  // namespace
}  // namespace slicefarm::config::template_types_test
