#include "common/config/presets/preset_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/presets/preset_files_test.h"

namespace slicefarm::config::presets::preset_set_test {
namespace {

/// Preset with its parents and settings, written as `key=value`.
struct Given {
  std::string name;
  std::vector<std::string> parents;
  std::vector<std::string> settings;
};

PresetSet SetOf(const std::vector<Given>& all) {
  PresetSet set;
  const int32_t scope = set.AddScope({.vendor = "Acme"});
  for (const Given& given : all) {
    Preset preset;
    preset.kind = PresetKind::kProcess;
    preset.name = given.name;
    preset.parents = given.parents;
    preset.scope = scope;
    for (const std::string& text : given.settings)
      preset.settings.push_back({text.substr(0, text.find('=')), text.substr(text.find('=') + 1)});
    set.Add(std::move(preset));
  }
  return set;
}

std::string FlatText(const FlatPreset& flat) {
  std::string text;
  for (const auto& [key, value] : flat)
    text += key + "=" + value.value + " (" + value.from->name + ")\n";
  return text;
}

struct Case {
  std::string name;
  std::vector<Given> presets;
  std::string flat;  ///< flat settings of the preset "x"
};

class FlattenTest : public testing::TestWithParam<Case> {};

TEST_P(FlattenTest, TellsSources) {
  const PresetSet set = SetOf(GetParam().presets);
  const Preset* preset = Only(set, PresetKind::kProcess, "x");
  ASSERT_NE(preset, nullptr);
  const auto flat = set.Flatten(*preset);
  ASSERT_TRUE(flat.ok()) << flat.status();
  EXPECT_EQ(FlatText(*flat), GetParam().flat);
}

INSTANTIATE_TEST_SUITE_P(
    Presets, FlattenTest,
    testing::Values(
        Case{"Alone", {{"x", {}, {"a=1"}}}, "a=1 (x)\n"},
        Case{"LastOfEqualKeys", {{"x", {}, {"a=1", "a=2"}}}, "a=2 (x)\n"},
        Case{"OwnWins", {{"p", {}, {"a=1", "b=1"}}, {"x", {"p"}, {"a=2"}}}, "a=2 (x)\nb=1 (p)\n"},
        Case{"EmptyValueWins", {{"p", {}, {"a=1"}}, {"x", {"p"}, {"a="}}}, "a= (x)\n"},
        Case{"LaterParentWins",
             {{"p", {}, {"a=p", "b=p"}}, {"q", {}, {"a=q"}}, {"x", {"p", "q"}, {}}},
             "a=q (q)\nb=p (p)\n"},
        Case{"AncestorOfALaterParentWins",
             {{"r", {}, {"a=r"}}, {"p", {}, {"a=p"}}, {"q", {"r"}, {}}, {"x", {"p", "q"}, {}}},
             "a=r (r)\n"},
        Case{"Diamond",
             {{"r", {}, {"a=r", "b=r"}},
              {"p", {"r"}, {"a=p"}},
              {"q", {"r"}, {"b=q"}},
              {"x", {"p", "q"}, {}}},
             "a=r (r)\nb=q (q)\n"}),
    [](const auto& info) { return info.param.name; });

struct ErrorCase {
  std::string name;
  std::vector<Given> presets;
  Reason reason;
  std::string message;
};

class FlattenErrorTest : public testing::TestWithParam<ErrorCase> {};

TEST_P(FlattenErrorTest, IsTyped) {
  const PresetSet set = SetOf(GetParam().presets);
  const Preset* preset = Only(set, PresetKind::kProcess, "x");
  ASSERT_NE(preset, nullptr);
  const absl::Status status = set.Flatten(*preset).status();
  EXPECT_EQ(DetailOf(status).reason, GetParam().reason) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr(GetParam().message));
}

/// Returns a preset "x" with `count` generations above it.
std::vector<Given> Generations(int count) {
  std::vector<Given> all = {{"x", {"0"}, {}}};
  for (int i = 0; i < count; ++i) all.push_back({std::to_string(i), {std::to_string(i + 1)}, {}});
  all.push_back({std::to_string(count), {}, {"a=1"}});
  return all;
}

/// Returns a preset "x" with many parents.
std::vector<Given> ManyParents(size_t count) {
  std::vector<Given> all = {{"x", {}, {}}};
  for (size_t i = 0; i < count; ++i) {
    all.front().parents.push_back(std::to_string(i));
    all.push_back({std::to_string(i), {}, {}});
  }
  return all;
}

/// Returns a preset "x" with 2^60 paths to its oldest ancestor.
std::vector<Given> Doubled() {
  std::vector<Given> all = {{"x", {"0", "0"}, {}}};
  for (int i = 0; i < 60; ++i) {
    const std::string next = std::to_string(i + 1);
    all.push_back({std::to_string(i), {next, next}, {}});
  }
  all.push_back({"60", {}, {"a=1"}});
  return all;
}

INSTANTIATE_TEST_SUITE_P(
    Presets, FlattenErrorTest,
    testing::Values(ErrorCase{"MissingParent",
                              {{"x", {"Gone"}, {}}},
                              Reason::kProfileNotFound,
                              R"("x" inherits from "Gone")"},
                    ErrorCase{"Itself", {{"x", {"x"}, {}}}, Reason::kSettingMalformed, "itself"},
                    ErrorCase{"Cycle",
                              {{"x", {"p"}, {}}, {"p", {"q"}, {}}, {"q", {"x"}, {}}},
                              Reason::kSettingMalformed,
                              "inherits from itself"},
                    ErrorCase{"Deep", Generations(100), Reason::kRequestTooLarge, "generations"},
                    ErrorCase{"Wide", ManyParents(1'001), Reason::kRequestTooLarge,
                              "inherits from"}),
    [](const auto& info) { return info.param.name; });

TEST(PresetSetTest, ReportsAPresetOfAUserWithTheNameOfAnother) {
  PresetSet set;
  const int32_t acme = set.AddScope({.vendor = "Acme"}), other = set.AddScope({.vendor = "Other"});
  const int32_t user = set.AddScope({});
  const auto add = [&](int32_t scope, const std::string& file, bool listed = true) {
    Preset preset;
    preset.name = "One";
    preset.scope = scope;
    preset.file = file;
    preset.listed = listed;
    set.Add(std::move(preset));
  };
  add(acme, "acme.json");
  add(other, "other.json");  // vendors may have the same names
  add(user, "base.json", /*listed=*/false);
  EXPECT_THAT(set.problems(), testing::IsEmpty());
  add(user, "mine.json");
  EXPECT_THAT(set.problems(), testing::ElementsAre(
                                  "mine.json: the printer preset \"One\" is also in acme.json; the "
                                  "name chooses only one of them"));
}

// With a search among all presets of the same name, this test does not end in the time of a test.
TEST(PresetSetTest, AddsVeryManyPresetsWithTheSameName) {
  constexpr int kPresets = 300'000;
  PresetSet set;
  const int32_t acme = set.AddScope({.vendor = "Acme"}), user = set.AddScope({});
  Preset preset;
  preset.name = "One";
  preset.scope = acme;
  for (int i = 0; i < kPresets; ++i) set.Add(preset);
  EXPECT_THAT(set.problems(), testing::IsEmpty());
  preset.scope = user;
  set.Add(preset);
  EXPECT_THAT(set.problems(), testing::SizeIs(1));
}

TEST(PresetSetTest, VisitsAnAncestorOnce) {
  const PresetSet set = SetOf(Doubled());
  const auto lineage = set.Lineage(*Only(set, PresetKind::kProcess, "x"));
  ASSERT_TRUE(lineage.ok()) << lineage.status();
  EXPECT_EQ(lineage->size(), 62U);
}

}  // namespace
}  // namespace slicefarm::config::presets::preset_set_test
