#include "common/config/table/settings_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/process_settings.h"
#include "common/config/table/known_keys.h"

namespace slicefarm::config::settings_table_test {
namespace {

using testing::HasSubstr;

bool IsNumeric(const SettingSpec& spec) {
  return spec.kind == Kind::kInteger || spec.kind == Kind::kNumber || spec.kind == Kind::kPercent ||
         spec.kind == Kind::kNumberOrPercent;
}

/// Returns true if the choice is another name for an earlier value. Old profiles have such names;
/// the first name is the one that is printed. Ignored limits also count, because they are a set of
/// limits of their own.
bool IsOtherSpelling(const Choice& choice, const SettingSpec& spec) {
  if (spec.key == "machine_limits_usage" && choice.value == kIgnoreLimits) return true;
  return std::ranges::any_of(spec.choices, [&](const Choice& other) {
    return &other < &choice && other.note.empty() && other.value == choice.value;
  });
}

/// Returns different values of the setting, in the form of a config.ini.
std::vector<std::string> Samples(const SettingSpec& spec) {
  switch (spec.kind) {
    case Kind::kFlag:
      return {"0", "1"};
    case Kind::kChoice: {
      std::vector<std::string> names;
      for (const Choice& choice : spec.choices) {
        if (choice.note.empty() && !IsOtherSpelling(choice, spec)) names.emplace_back(choice.name);
      }
      return names;
    }
    case Kind::kText:
      return spec.list == List::kNone ? std::vector<std::string>{"MK4", "two words; and \\\\"}
                                      : std::vector<std::string>{"PLA", "\"two words; \\\"q\\\"\""};
    case Kind::kGcode:
      return spec.list == List::kNone ? std::vector<std::string>{"G28", "G28 ; home\\nM84", ""}
                                      : std::vector<std::string>{"G28", "\"G28 ; home\\nM84\"", ""};
    case Kind::kBedShape:
      return {"0x0,250x0,250x210,0x210", "-50.5x-50,50x-50,0x50.000001"};
    case Kind::kAreas:
      return {"", "0x0,18x0,18x28,0x28", "0x0,9x0,9x9,0x9,20x0,30x0,30x9,20x9", "0x0,5x0,3x4.5"};
    case Kind::kPoint:
      return {"0x0", "-1.5x2"};
    case Kind::kSizes:
      return {"", "16x16", "32x32,300x200"};
    case Kind::kDensityField:
      return {"", R"({"kind":"height","table":[[0,0.2],[5,0.25]],"law":"simp"})"};
    case Kind::kStressField:
      return {
          "",
          R"({"kind":"voxels","count":[1,1,1],"origin":[0,0,0],"spacing":[1,1,1],"stress":[1,0,0.5]})"};
    case Kind::kMaterialField:
      return {
          "",
          R"({"parts":[{"kind":"height","table":[[0,0.4]]},{"kind":"height","table":[[0,0.6]]}]})"};
    case Kind::kLayerHeights:
      return {"", "0;0.2", "0;0.2;5.5;0.1;5.5;0.3"};
    case Kind::kAngles:
      return {"", "0,90", "45#2,+30"};
    case Kind::kSolidLayers:
      return {"", "5#2", "1,7#2,9"};
    case Kind::kHeightCode:
      return {"", R"([{"z":1.5,"type":"pause","text":"a"}])"};
    case Kind::kSubstitutions:
      return {"", R"(a;"b c";r;)"};
    case Kind::kAdvancePoints:
      return {"", "0.04,4,3000;0.03,8,3000"};
    case Kind::kFlowTable:
      return {"0,0.5;2,1", "0,1.25;0.5,0.75;1,1"};
    case Kind::kCutter:
      return {"ball:4", "bull:6:1.5", "conecone:2:60:20:6"};
    case Kind::kPercent:
      return {PrintNumber(spec.min) + "%", PrintNumber(spec.max) + "%",
              PrintNumber(Quantise(spec.min + (spec.max - spec.min) / 3)) + "%"};
    default: {
      double middle = Quantise((spec.min + spec.max) / 2);
      if (spec.kind == Kind::kInteger) middle = std::floor(middle);
      return {PrintNumber(spec.min), PrintNumber(spec.max), PrintNumber(middle)};
    }
  }
}

/// Setting of a process.
struct Row {
  Process process;
  int index = 0;
};

std::vector<Row> AllRows() {
  std::vector<Row> rows;
  for (const ProcessInfo& info : kProcesses)
    for (int i = 0; i < std::ssize(SettingsTable(info.process)); ++i)
      rows.push_back({info.process, i});
  return rows;
}

class EverySetting : public testing::TestWithParam<Row> {
 protected:
  const SettingSpec& spec() const { return SettingsTable(GetParam().process)[GetParam().index]; }
};

TEST_P(EverySetting, IsDescribed) {
  EXPECT_FALSE(spec().doc.empty());
  EXPECT_FALSE(DescribeRange(spec()).empty());
  if (IsNumeric(spec())) {
    EXPECT_LT(spec().min, spec().max);
  }
  if (spec().kind == Kind::kChoice) {
    EXPECT_GE(Samples(spec()).size(), 2);
  }
}

TEST_P(EverySetting, IsFoundByItsKeyAndByNoOtherTable) {
  EXPECT_EQ(FindSetting(spec().key, GetParam().process), GetParam().index);
  const KnownKey* known = FindKnownKey(spec().key);
  EXPECT_TRUE(known == nullptr || known->key.ends_with('*')) << "claims to have no effect";
}

TEST_P(EverySetting, HasAStandardInItsRange) {
  if (spec().standard == kNotSet) return;
  const auto value = ParseValue(spec(), spec().standard);
  EXPECT_TRUE(value.ok()) << value.status();
}

TEST_P(EverySetting, PrintsWhatItReads) {
  const std::vector<std::string> samples = Samples(spec());
  ASSERT_FALSE(samples.empty());
  for (const std::string& sample : samples) {
    const auto value = ParseValue(spec(), sample);
    ASSERT_TRUE(value.ok()) << value.status();
    EXPECT_EQ(PrintValue(spec(), *value), sample);
  }
}

TEST_P(EverySetting, ReachesItsFieldsAndComesBack) {
  if (spec().field.set == nullptr) return;
  std::set<std::string> seen;
  for (const std::string& sample : Samples(spec())) {
    const auto value = ParseValue(spec(), sample);
    ASSERT_TRUE(value.ok()) << value.status();
    JobRows settings = SettingsOf(GetParam().process).Standards();
    spec().field.set(settings, *value);
    EXPECT_EQ(PrintValue(spec(), spec().field.get(settings)),
              sample == "0" && spec().key.starts_with("first_layer_speed") ? "100%" : sample);
    seen.insert(PrintValue(spec(), spec().field.get(settings)));
    if (spec().also.set == nullptr) continue;
    spec().also.set(settings, *value);
    EXPECT_EQ(spec().also.get(settings), spec().field.get(settings));
  }
  EXPECT_EQ(seen.size(), Samples(spec()).size());
}

TEST_P(EverySetting, RefusesWhatIsOutOfRange) {
  if (!IsNumeric(spec())) return;
  for (const double number : {spec().min - 1, spec().max + 1}) {
    const std::string written = PrintNumber(number);
    const auto value = ParseValue(spec(), written);
    ASSERT_FALSE(value.ok()) << written;
    const ErrorDetail detail = DetailOf(value.status());
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange);
    EXPECT_EQ(detail.metadata.at("setting"), spec().key);
    EXPECT_EQ(detail.metadata.at("value"), written);
    EXPECT_EQ(detail.metadata.at("min"), PrintNumber(spec().min));
    EXPECT_EQ(detail.metadata.at("max"), PrintNumber(spec().max));
    EXPECT_THAT(std::string(value.status().message()), HasSubstr(std::string(spec().key)));
    EXPECT_THAT(std::string(value.status().message()), HasSubstr(written));
  }
}

TEST_P(EverySetting, RefusesWhatIsMalformed) {
  if (spec().kind == Kind::kText || spec().kind == Kind::kGcode) {
    EXPECT_EQ(DetailOf(ParseValue(spec(), "bell\a").status()).reason, Reason::kSettingMalformed);
    return;
  }
  for (const char* text : {"banana", "0.5.5", "%", "\xff"}) {
    const auto value = ParseValue(spec(), text);
    ASSERT_FALSE(value.ok()) << text;
    EXPECT_EQ(DetailOf(value.status()).reason, Reason::kSettingMalformed) << value.status();
    EXPECT_EQ(DetailOf(value.status()).metadata.at("setting"), spec().key);
  }
}

TEST_P(EverySetting, TakesTheFirstOfAList) {
  if (spec().list == List::kNone) return;
  const bool text = spec().kind == Kind::kText || spec().kind == Kind::kGcode;
  const std::vector<std::string> samples = Samples(spec());
  ASSERT_FALSE(samples.empty());
  for (const std::string& sample : samples) {
    const auto one = ParseValue(spec(), sample);
    const auto two = ParseValue(spec(), sample + (text ? ";other" : " ,9999"));
    ASSERT_TRUE(two.ok()) << two.status();
    EXPECT_EQ(*two, *one);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EverySetting, testing::ValuesIn(AllRows()), [](const auto& info) {
  return absl::StrCat(std::string(ProcessName(info.param.process)), "_",
                      std::string(SettingsTable(info.param.process)[info.param.index].key));
});

TEST(SettingsTable, IsSortedWithoutRepetition) {
  for (const ProcessInfo& info : kProcesses) {
    const auto table = SettingsTable(info.process);
    for (size_t i = 1; i < table.size(); ++i) EXPECT_LT(table[i - 1].key, table[i].key);
  }
}

TEST(SettingsTable, RelatesToSettingsOfItsOwn) {
  int related = 0;
  for (const ProcessInfo& info : kProcesses) {
    for (const SettingSpec& spec : SettingsTable(info.process)) {
      if (spec.relative_to.empty()) continue;
      ++related;
      EXPECT_GE(FindSetting(spec.relative_to, info.process), 0) << spec.key;
    }
  }
  EXPECT_GT(related, 0);
}

class EveryTable : public testing::TestWithParam<Process> {};

TEST_P(EveryTable, HasNoTwoSettingsForOneField) {
  ASSERT_FALSE(SettingsTable(GetParam()).empty());
  // Each setting changes only its own text.
  for (const SettingSpec& changed : SettingsTable(GetParam())) {
    if (changed.field.set == nullptr) continue;
    JobRows settings = SettingsOf(GetParam()).Standards();
    const JobRows before = settings;
    for (const std::string& sample : Samples(changed)) {
      changed.field.set(settings, *ParseValue(changed, sample));
      if (changed.also.set) changed.also.set(settings, *ParseValue(changed, sample));
      for (const SettingSpec& other : SettingsTable(GetParam())) {
        if (other.field.get == nullptr || other.key == changed.key) continue;
        EXPECT_EQ(other.field.get(settings), other.field.get(before))
            << changed.key << " changes " << other.key;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryTable, testing::ValuesIn([] {
                           std::vector<Process> all;
                           for (const ProcessInfo& info : kProcesses) all.push_back(info.process);
                           return all;
                         }()),
                         [](const auto& info) { return std::string(ProcessName(info.param)); });

TEST(FindSetting, KnowsOnlyTheTable) {
  EXPECT_EQ(FindSetting("", Process::kFdm), -1);
  EXPECT_EQ(FindSetting("zzz", Process::kFdm), -1);
  EXPECT_EQ(FindSetting("layer_heigh", Process::kFdm), -1);
}

TEST(ParseValue, ShortensWhatItQuotes) {
  const SettingSpec& spec =
      SettingsTable(Process::kFdm)[FindSetting("layer_height", Process::kFdm)];
  const auto value = ParseValue(spec, std::string(100'000, '9'));
  ASSERT_FALSE(value.ok());
  EXPECT_LT(value.status().message().size(), 300);
}

TEST(ParseValue, RefusesNewlinesInNames) {
  // The text is quoted in a comment of the G-code. Characters after a newline would be a command.
  for (const char* key : {"filament_type", "filament_colour", "filament_settings_id"}) {
    EXPECT_FALSE(
        ParseValue(SettingsTable(Process::kFdm)[FindSetting(key, Process::kFdm)], "\"PLA\\nM112\"")
            .ok())
        << key;
  }
  EXPECT_FALSE(ParseValue(SettingsTable(Process::kFdm)[FindSetting("printer_model", Process::kFdm)],
                          "MK4\\nM112")
                   .ok());
}

TEST(ParseValue, ReadsPercentWithAndWithoutItsSign) {
  const SettingSpec& spec =
      SettingsTable(Process::kFdm)[FindSetting("fill_density", Process::kFdm)];
  EXPECT_EQ(ParseValue(spec, "20%")->number, 20);
  EXPECT_EQ(ParseValue(spec, "20")->number, 20);
}

TEST(KnownKeys, SayWhy) {
  for (const char* key :
       {"automatic_extrusion_widths", "wipe_tower", "compatible_printers_condition_cummulative",
        "print_host", "post_process", "variable_layer_height"}) {
    ASSERT_NE(FindKnownKey(key), nullptr) << key;
    EXPECT_FALSE(FindKnownKey(key)->why.empty()) << key;
  }
  EXPECT_EQ(FindKnownKey("banana"), nullptr);
  EXPECT_EQ(FindKnownKey(""), nullptr);
}

TEST(KnownKeys, KnowWhichValueAsksForNothing) {
  EXPECT_TRUE(IsNeutral(*FindKnownKey("interlocking_beam"), "0"));
  EXPECT_FALSE(IsNeutral(*FindKnownKey("interlocking_beam"), "1"));
  EXPECT_TRUE(IsNeutral(*FindKnownKey("infill_extruder"), "0,1"));
  EXPECT_FALSE(IsNeutral(*FindKnownKey("infill_extruder"), "2"));
  EXPECT_TRUE(IsNeutral(*FindKnownKey("ooze_prevention"), "0.0"));
  EXPECT_TRUE(IsNeutral(*FindKnownKey("infill_extruder"), "1,1"));
  EXPECT_FALSE(IsNeutral(*FindKnownKey("infill_extruder"), "1,2"));
  EXPECT_TRUE(IsNeutral(*FindKnownKey("post_process"), ""));
  EXPECT_TRUE(IsNeutral(*FindKnownKey("post_process"), "\"\""));
  EXPECT_FALSE(IsNeutral(*FindKnownKey("post_process"), "rm.sh"));
  EXPECT_FALSE(IsNeutral(*FindKnownKey("filament_load_time"), "0"));
}

TEST(SettingsTable, ScopesAreThoseOfPrusaSlicer) {
  const auto scope_of = [](std::string_view key) {
    return SettingsTable(Process::kFdm)[FindSetting(key, Process::kFdm)].scope();
  };
  for (const char* key : {"fill_density", "perimeters", "top_solid_min_thickness"})
    EXPECT_EQ(scope_of(key), Scope::kRegion) << key;
  for (const char* key : {"layer_height", "slicing_mode", "seam_position", "raft_layers",
                          "support_material_angle", "extrusion_width", "perimeter_generator"})
    EXPECT_EQ(scope_of(key), Scope::kObject) << key;
  for (const char* key : {"skirts", "first_layer_height", "temperature", "spiral_vase"})
    EXPECT_EQ(scope_of(key), Scope::kJob) << key;
  int regions = 0, objects = 0;
  for (const SettingSpec& spec : SettingsTable(Process::kFdm)) {
    regions += spec.scope() == Scope::kRegion;
    objects += spec.scope() == Scope::kObject;
  }
  EXPECT_EQ(regions, 167);
  EXPECT_EQ(objects, 96);
}

TEST(SettingsTable, EverySettingHasAKindAndAGroup) {
  for (const ProcessInfo& info : kProcesses) {
    ASSERT_FALSE(SettingsTable(info.process).empty());
    for (const SettingSpec& spec : SettingsTable(info.process)) {
      EXPECT_FALSE(KindName(spec.kind).empty()) << spec.key;
      EXPECT_FALSE(spec.group.empty()) << spec.key;
    }
  }
}

}  // namespace
}  // namespace slicefarm::config::settings_table_test
