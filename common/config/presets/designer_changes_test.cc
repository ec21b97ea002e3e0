#include "common/config/presets/designer_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/presets/preset_files_test.h"

namespace slicefarm::config::presets::designer_changes_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr char kBundle[] =
    "[vendor]\nname = Acme\n"
    "[print:0.20mm NORMAL]\nlayer_height = 0.2\nperimeters = 2\nfill_density = 15%\n"
    "perimeter_speed = 45\ncompatible_printers_condition = nozzle_diameter[0]==0.4\n"
    "[filament:PLA]\nmax_fan_speed = 100\ntemperature = 210\n"
    "[printer:Acme A]\nnozzle_diameter = 0.4\n";

const PresetSet& Bundle() {
  static const auto* const set = new PresetSet(*ReadPresets(Files({{"a.ini", kBundle}})));
  return *set;
}

std::vector<std::string> Texts(const std::vector<Setting>& settings) {
  std::vector<std::string> texts;
  for (const Setting& setting : settings) texts.push_back(setting.key + "=" + setting.value);
  return texts;
}

Project Orca(std::vector<Setting> settings) {
  Project project;
  project.dialect = SettingsDialect::kOrca;
  project.settings = std::move(settings);
  return project;
}

Project Prusa(std::vector<Setting> settings) {
  Project project;
  project.settings = std::move(settings);
  return project;
}

TEST(ChangesOf, AreThoseThatOrcaSlicerLists) {
  const Project project =
      Orca({{"different_settings_to_system",
             R"(["wall_loops;layer_height","fan_max_speed","","z_hop"])"},
            {"inherits_group", R"(["0.20mm Standard @X","","Acme PETG @X",""])"},
            {"print_settings_id", "Mine"},
            {"filament_settings_id", R"(["Generic PLA @X","My PETG"])"},
            {"filament_type", R"(["PLA","PETG"])"},
            {"nozzle_diameter", R"(["0.6","0.4"])"},
            {"layer_height", "0.28"},
            {"wall_loops", "5"},
            {"fan_max_speed", R"(["80","30"])"},
            {"z_hop", R"(["0.2"])"}});
  const DesignerChanges first = ChangesOf(project, 0, Bundle());
  EXPECT_FALSE(first.unknown);
  EXPECT_THAT(Texts(first.process), ElementsAre("wall_loops=5", "layer_height=0.28"));
  EXPECT_THAT(Texts(first.filament), ElementsAre(R"(fan_max_speed=["80"])"));
  EXPECT_THAT(first.of_printer, ElementsAre("z_hop"));
  EXPECT_EQ(first.nozzle_mm, 0.6);
  EXPECT_EQ(first.former.process_alias, "0.20mm Standard");
  EXPECT_EQ(first.former.filament_alias, "Generic PLA");
  EXPECT_EQ(first.former.filament_type, "PLA");
  const DesignerChanges second = ChangesOf(project, 1, Bundle());
  EXPECT_THAT(second.filament, IsEmpty());
  EXPECT_EQ(second.former.filament_alias, "Acme PETG") << "the parent of a user's preset";
  EXPECT_EQ(second.former.filament_type, "PETG");
}

TEST(ChangesOf, AreNoneForAVendorsProcessWithoutAList) {
  const DesignerChanges changes = ChangesOf(
      Orca({{"print_settings_id", "0.20mm Standard @X"}, {"wall_loops", "3"}}), 0, Bundle());
  EXPECT_FALSE(changes.unknown);
  EXPECT_THAT(changes.process, IsEmpty());
}

TEST(ChangesOf, AreThePartsSettingsForAProcessWithoutAParent) {
  const DesignerChanges changes = ChangesOf(Orca({{"print_settings_id", "All mine"},
                                                  {"inherits_group", R"(["Root","",""])"},
                                                  {"different_settings_to_system", R"(["","",""])"},
                                                  {"wall_loops", "3"},
                                                  {"outer_wall_speed", "90"},
                                                  {"nozzle_temperature", R"(["230"])"}}),
                                            0, Bundle());
  EXPECT_TRUE(changes.unknown);
  EXPECT_THAT(Texts(changes.process), ElementsAre("wall_loops=3"));
}

TEST(ChangesOf, AreDifferencesFromPrusaSlicersPresets) {
  const DesignerChanges changes = ChangesOf(Prusa({{"print_settings_id", "0.20mm NORMAL"},
                                                   {"filament_settings_id", "PLA"},
                                                   {"layer_height", "0.20"},
                                                   {"perimeters", "4"},
                                                   {"fill_density", "15%"},
                                                   {"perimeter_speed", "30"},
                                                   {"temperature", "220"},
                                                   {"bed_shape", "0x0,9x0,9x9"}}),
                                            0, Bundle());
  EXPECT_FALSE(changes.unknown);
  EXPECT_THAT(Texts(changes.process), ElementsAre("perimeter_speed=30", "perimeters=4"));
  EXPECT_THAT(Texts(changes.filament), ElementsAre("temperature=220"));
}

TEST(ChangesOf, AreDifferencesFromTheParentOfAUsersPreset) {
  const DesignerChanges changes =
      ChangesOf(Prusa({{"print_settings_id", "Mine"},
                       {"inherits_cummulative", R"("0.20mm NORMAL";;"Acme A")"},
                       {"filament_settings_id", R"("My PLA")"},
                       {"perimeters", "3"}}),
                0, Bundle());
  EXPECT_THAT(Texts(changes.process), ElementsAre("perimeters=3"));
  EXPECT_EQ(changes.former.process_alias, "0.20mm NORMAL");
}

TEST(ChangesOf, AreThePartsSettingsForAnUnknownPresetOfPrusaSlicer) {
  const DesignerChanges changes = ChangesOf(
      Prusa({{"print_settings_id", "Mine"}, {"perimeters", "3"}, {"perimeter_speed", "80"}}), 0,
      Bundle());
  EXPECT_TRUE(changes.unknown);
  EXPECT_THAT(Texts(changes.process), ElementsAre("perimeters=3"));
}

}  // namespace
}  // namespace slicefarm::config::presets::designer_changes_test
