#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

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
TEST(TemplateDefaults, HaveTheSettingsOfTheTableWithoutAField) {
  int found = 0;
  for (const SettingSpec& spec : SettingsTable(Process::kFdm)) {
    if (spec.field.set != nullptr || !macro::TypeOfSetting(spec.key)) continue;
    const auto lines = macro::SettingLines(macro::TemplateDefaults());
    const bool has = std::ranges::any_of(lines, [&](const auto& line) {
      return line.first == spec.key && line.second == spec.standard;
    });
    EXPECT_TRUE(has) << spec.key;
    found += has ? 1 : 0;
  }
  EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace slicefarm::config::template_types_test
