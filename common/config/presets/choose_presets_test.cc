#include "common/config/presets/choose_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/presets/job_presets.h"
#include "common/config/presets/preset_files_test.h"

namespace slicefarm::config::presets::choose_presets_test {
namespace {

const PresetSet& Acme() {
  static const auto* const set = new PresetSet(*ReadPresets(OrcaFolder()));
  return *set;
}

struct Case {
  std::string name;
  PresetNames given;
  std::string chosen;  ///< names of the presets, or the reason of the error
  std::string message = {};
};

class ChoosePresetsTest : public testing::TestWithParam<Case> {};

TEST_P(ChoosePresetsTest, ByName) {
  const auto chosen = ChoosePresets(Acme(), GetParam().given);
  if (!chosen.ok()) {
    EXPECT_EQ(ReasonName(DetailOf(chosen.status()).reason), GetParam().chosen) << chosen.status();
    EXPECT_THAT(std::string(chosen.status().message()), testing::HasSubstr(GetParam().message));
    return;
  }
  EXPECT_EQ(chosen->printer->name + ", " + chosen->process->name + ", " + chosen->filament->name,
            GetParam().chosen);
}

INSTANTIATE_TEST_SUITE_P(
    Presets, ChoosePresetsTest,
    testing::Values(
        Case{"Full",
             {"Acme One 0.4", "0.20mm @One", "Acme PLA @One"},
             "Acme One 0.4, 0.20mm @One, Acme PLA @One"},
        Case{"Alias",
             {"Acme One 0.6", "0.30mm", "Acme PLA"},
             "Acme One 0.6, 0.30mm @One 0.6, Acme PLA @One"},
        Case{"Defaults", {"Acme One 0.4", "", ""}, "Acme One 0.4, 0.20mm @One, Acme PLA @One"},
        Case{"DefaultOfAnotherPrinterByAlias",
             {"Acme Two", "", ""},
             "Acme Two, 0.20mm @Two, Acme PLA @One"},
        Case{"OldName",
             {"Acme Uno 0.6", "0.30mm", "Generic PLA"},
             "Acme One 0.6, 0.30mm @One 0.6, Generic PLA @System"},
        Case{"UserPrinterTakesPresetsOfItsParent",
             {"My One", "0.20mm", "Acme PLA"},
             "My One, 0.20mm @One, Acme PLA @One"},
        Case{"UserProcess", {"My One", "Fast", ""}, "My One, Fast, Acme PLA @One"},
        Case{"Model", {"Acme One", "", ""}, "REQUEST_MALFORMED", R"("Acme One 0.4", "Acme One)"},
        Case{"NoSuchPrinter",
             {"Acme Onne 0.4", "", ""},
             "PROFILE_NOT_FOUND",
             R"(do you mean "Acme One 0.4"?)"},
        Case{"NoSuchProcess",
             {"Acme One 0.4", "0.20m", ""},
             "PROFILE_NOT_FOUND",
             R"(do you mean "0.20mm")"},
        Case{"BaseIsNoProcess", {"Acme One 0.4", "fdm", ""}, "PROFILE_NOT_FOUND", ""},
        Case{"OtherPrintersProcess",
             {"Acme One 0.4", "0.30mm @One 0.6", ""},
             "REQUEST_MALFORMED",
             R"(is not made for "Acme One 0.4"; the presets for this printer are "0.20mm @One")"},
        Case{"NoDefaultProcessIsTheFirst",
             {"Acme One 0.6", "", ""},
             "Acme One 0.6, 0.30mm @One 0.6, Acme PLA @One"}),
    [](const auto& info) { return info.param.name; });

TEST(ChoosePresets, NotesAStandInForTheDefault) {
  const auto chosen = ChoosePresets(Acme(), {"Acme One 0.6", "", ""});
  ASSERT_TRUE(chosen.ok()) << chosen.status();
  ASSERT_EQ(chosen->notes.size(), 1U);
  EXPECT_THAT(chosen->notes[0], testing::HasSubstr("\"0.30mm @One 0.6\" is used"));
  EXPECT_TRUE(ChoosePresets(Acme(), {"Acme One 0.4", "", ""})->notes.empty());
}

/// Bundle with processes of three heights and filaments of two materials.
constexpr char kHeights[] =
    "[print:a 0.1 @P]\nlayer_height = 0.1\n[print:b 0.20 @P]\nlayer_height = 0.20\n"
    "[print:c 0.2 @P]\nlayer_height = 0.2\n[print:d 0.3 @P]\nlayer_height = 0.3\n"
    "[filament:1 ABS @P]\nfilament_type = ABS\n[filament:2 PLA @P]\nfilament_type = PLA\n"
    "[filament:3 PLA @P]\nfilament_type = PLA\n"
    "[printer:P]\ndefault_print_profile = c 0.2 @P\ndefault_filament_profile = %\n";

struct FormerCase {
  std::string name;
  FormerPresets former;
  std::string filament;  ///< the printer's default
  std::string chosen;
};

class FormerPresetsTest : public testing::TestWithParam<FormerCase> {};

TEST_P(FormerPresetsTest, DecideWithoutNames) {
  std::string text = kHeights;
  text.replace(text.find('%'), 1, GetParam().filament);
  const auto set = ReadPresets(Files({{"a.ini", text}}));
  ASSERT_TRUE(set.ok()) << set.status();
  const auto chosen = ChoosePresets(*set, {"P", "", ""}, GetParam().former);
  ASSERT_TRUE(chosen.ok()) << chosen.status();
  EXPECT_EQ(chosen->process->name + ", " + chosen->filament->name, GetParam().chosen);
}

INSTANTIATE_TEST_SUITE_P(
    Presets, FormerPresetsTest,
    testing::Values(
        FormerCase{"None", {}, "3 PLA @P", "c 0.2 @P, 3 PLA @P"},
        FormerCase{"NoneAndNoDefaultFilament", {}, "gone", "c 0.2 @P, 2 PLA @P"},
        FormerCase{"Alias", {"b 0.20", "0.1", "1 ABS", "PLA"}, "3 PLA @P", "b 0.20 @P, 1 ABS @P"},
        FormerCase{"Height", {"x", "0.3", "x", "ABS"}, "3 PLA @P", "d 0.3 @P, 1 ABS @P"},
        FormerCase{
            "DefaultOfEqualHeight", {"x", "0.2", "x", "PLA"}, "3 PLA @P", "c 0.2 @P, 3 PLA @P"},
        FormerCase{"NoEqualHeight", {"x", "0.15", "x", "TPU"}, "3 PLA @P", "c 0.2 @P, 3 PLA @P"}),
    [](const auto& info) { return info.param.name; });

std::string ValueIn(const std::vector<Setting>& settings, std::string_view key) {
  for (const Setting& setting : settings)
    if (setting.key == key) return setting.value;
  return "(none)";
}

TEST(JobPresetsTest, HaveTheirSettingsInPrusaSlicersNames) {
  const auto chosen = ChoosePresets(Acme(), {"My One", "Fast", "Acme PLA"});
  ASSERT_TRUE(chosen.ok()) << chosen.status();
  const auto job = SettingsOfPresets(Acme(), *chosen);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(ValueIn(job->settings, "external_perimeter_speed"), "120");
  EXPECT_EQ(ValueIn(job->settings, "perimeters"), "4");
  EXPECT_EQ(ValueIn(job->settings, "temperature"), "225,230");
  EXPECT_EQ(ValueIn(job->settings, "start_gcode"), R"(G28\nPRIME)");
  EXPECT_EQ(ValueIn(job->settings, "bed_shape"), "0x0,220x0,220x220,0x220");
  // The model has a textured plate, and a process has no temperature of the nozzle.
  EXPECT_EQ(ValueIn(job->settings, "bed_temperature"), "55");
  // No preset sets the pattern: OrcaSlicer's default is crosshatch, not PrusaSlicer's stars.
  const auto values = CombinePresets(Acme(), *chosen);
  ASSERT_TRUE(values.ok());
  const auto pattern = std::ranges::find(*values, "sparse_infill_pattern", &SourcedValue::key);
  ASSERT_NE(pattern, values->end());
  EXPECT_EQ(pattern->value, "crosshatch");
  EXPECT_EQ(pattern->from, nullptr);
}

struct KindCase {
  std::string name;
  std::string text;  ///< text of a bundle with a printer P, a process Q and a filament F
  std::string key;
  std::string value;
};

class KindOfKeyTest : public testing::TestWithParam<KindCase> {};

TEST_P(KindOfKeyTest, DecidesWhoseValueCounts) {
  const auto set = ReadPresets(Files({{"a.ini", GetParam().text}}));
  ASSERT_TRUE(set.ok()) << set.status();
  const auto chosen = ChoosePresets(*set, {"P", "Q", "F"});
  ASSERT_TRUE(chosen.ok()) << chosen.status();
  const auto job = SettingsOfPresets(*set, *chosen);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(ValueIn(job->settings, GetParam().key), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    Presets, KindOfKeyTest,
    testing::Values(
        KindCase{"OwnKind", "[printer:P]\na = 1\n[print:Q]\nlayer_height = 0.3\n[filament:F]\n",
                 "layer_height", "0.3"},
        KindCase{"WrongKindIsIgnored",
                 "[printer:P]\na = 1\n[print:Q]\nlayer_height = 0.3\n[filament:F]\n"
                 "layer_height = 0.1\n",
                 "layer_height", "0.3"},
        KindCase{"UnknownKeyCounts", "[printer:P]\na = 1\n[print:Q]\n[filament:F]\nb = 2\n", "b",
                 "2"},
        KindCase{"SuperSlicersPrinterHasClearances",
                 "[printer:P]\nextruder_clearance_radius = 40\n[print:Q]\ndefault_speed = 60\n"
                 "[filament:F]\n",
                 "extruder_clearance_radius", "40"}),
    [](const auto& info) { return info.param.name; });

TEST(CompatibleTest, LibraryGivesWayToTheVendorsFilament) {
  std::vector<PresetFile> files = OrcaFolder();
  for (PresetFile& file : files)
    if (file.path.ends_with("any.json"))
      file.bytes = R"({"type": "filament", "name": "Acme PLA @System", "instantiation": "true"})";
  for (PresetFile& file : files)
    if (file.path.ends_with("OrcaFilamentLibrary.json"))
      file.bytes = R"({"machine_list": [], "filament_list": [
          {"name": "lib_pla", "sub_path": "filament/lib_pla.json"},
          {"name": "Acme PLA @System", "sub_path": "filament/any.json"}]})";
  const auto set = ReadPresets(files);
  ASSERT_TRUE(set.ok()) << set.status();
  const auto fit = PrinterFit::Make(*set, *Only(*set, PresetKind::kPrinter, "Acme One 0.4"));
  ASSERT_TRUE(fit.ok()) << fit.status();
  EXPECT_TRUE(fit->Accepts(*Only(*set, PresetKind::kFilament, "Acme PLA @One")));
  EXPECT_FALSE(fit->Accepts(*Only(*set, PresetKind::kFilament, "Acme PLA @System")));
}

}  // namespace
}  // namespace slicefarm::config::presets::choose_presets_test
