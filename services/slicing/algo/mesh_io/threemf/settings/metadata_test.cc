#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::metadata_test {
namespace {

absl::StatusOr<Metadata> Read(const Files& files) {
  const std::string bytes = Zipped(files);
  return ReadMetadata(*Archive::Open(bytes));
}

TEST(ReadMetadata, KnowsTheSlicers) {
  const auto none = Read(CubeFiles());
  ASSERT_TRUE(none.ok()) << none.status();
  EXPECT_FALSE(none->has_printer);
  const auto prusa = Read(PrusaFiles());
  ASSERT_TRUE(prusa.ok()) << prusa.status();
  EXPECT_EQ(prusa->dialect, SettingsDialect::kPrusa);
  EXPECT_TRUE(prusa->has_printer);
  EXPECT_EQ(prusa->project.settings.size(), 2u);
  EXPECT_EQ(prusa->model.objects.size(), 2u);
  EXPECT_EQ(prusa->ranges.at(2).size(), 1u);
  const auto bambu = Read(BambuFiles());
  ASSERT_TRUE(bambu.ok()) << bambu.status();
  EXPECT_EQ(bambu->dialect, SettingsDialect::kOrca);
  EXPECT_EQ(bambu->model.plates.size(), 2u);
  EXPECT_EQ(bambu->ranges.at(1).size(), 1u);
}

TEST(ReadMetadata, WhatIsDoneAtHeightsIsASetting) {
  Files prusa = PrusaFiles();
  prusa.emplace_back("Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
                     R"(<custom_gcodes_per_print_z><code print_z="1.2" type="1" extra="nut"/>)"
                     R"(</custom_gcodes_per_print_z>)");
  const auto of_project = Read(prusa);
  ASSERT_TRUE(of_project.ok()) << of_project.status();
  EXPECT_EQ(of_project->project.settings.back().key, "custom_gcode_per_print_z");
  EXPECT_EQ(of_project->project.settings.back().value,
            R"([{"z":1.2,"type":"pause","text":"nut"}])");
  Files bambu = BambuFiles();
  bambu.emplace_back("Metadata/custom_gcode_per_layer.xml",
                     R"(<a><plate><plate_info id="2"/><layer top_z="3" type="3"/></plate></a>)");
  const auto of_plate = Read(bambu);
  ASSERT_TRUE(of_plate.ok()) << of_plate.status();
  for (const PlateSettings& plate : of_plate->model.plates) {
    const bool has =
        !plate.settings.empty() && plate.settings.back().key == "custom_gcode_per_print_z";
    EXPECT_EQ(has, plate.number == 2) << plate.number;
  }
}

/// PrusaSlicer writes an element for each bed and no root element around them.
TEST(ReadMetadata, BedsArePlates) {
  Files files = PrusaFiles();
  files.emplace_back("Metadata/Prusa_Slicer_wipe_tower_information.xml",
                     "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                     "<wipe_tower_information bed_idx=\"0\" position_x=\"170\"/>\n"
                     "<wipe_tower_information bed_idx=\"1\" position_x=\"170\"/>\n"
                     "<wipe_tower_information bed_idx=\"2\" position_x=\"170\"/>");
  files.emplace_back("Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
                     "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                     R"(<custom_gcodes_per_print_z bed_idx="0"><mode value="SingleExtruder"/>)"
                     "</custom_gcodes_per_print_z>\n"
                     R"(<custom_gcodes_per_print_z bed_idx="2"><code print_z="1.2" type="1" )"
                     R"(extra="nut"/></custom_gcodes_per_print_z>)");
  const auto metadata = Read(files);
  ASSERT_TRUE(metadata.ok()) << metadata.status();
  ASSERT_EQ(metadata->beds.size(), 3u);
  for (const PlateSettings& bed : metadata->beds)
    EXPECT_EQ(bed.settings.empty(), bed.number != 3) << bed.number;
  EXPECT_EQ(metadata->project.settings.size(), 2u);
}

TEST(ReadMetadata, OneBedIsNoPlate) {
  Files files = PrusaFiles();
  files.emplace_back("Metadata/Prusa_Slicer_wipe_tower_information.xml",
                     "<wipe_tower_information bed_idx=\"0\" position_x=\"170\"/>");
  const auto metadata = Read(files);
  ASSERT_TRUE(metadata.ok()) << metadata.status();
  EXPECT_TRUE(metadata->beds.empty());
}

TEST(ReadMetadata, NamesTheFileThatIsWrong) {
  for (const std::string name : {"Metadata/Slic3r_PE.config", "Metadata/Slic3r_PE_model.config",
                                 "Metadata/Prusa_Slicer_layer_config_ranges.xml"}) {
    const auto metadata = Read(With(PrusaFiles(), name, "<\xff = 1"));
    ASSERT_FALSE(metadata.ok()) << name;
    EXPECT_EQ(DetailOf(metadata.status()).metadata["part"], name);
  }
  const auto json = Read(With(BambuFiles(), "Metadata/project_settings.config", "{"));
  EXPECT_EQ(DetailOf(json.status()).reason, Reason::kMeshMalformed);
}

TEST(ReadMetadata, HasTheHeightsDrawnByHand) {
  const char* profile = "object_id=1|0.000000;0.200000;5.000000;0.100000\n";
  Files prusa = PrusaFiles(), bambu = BambuFiles();
  prusa.emplace_back("Metadata/Slic3r_PE_layer_heights_profile.txt", profile);
  bambu.emplace_back("Metadata/layer_heights_profile.txt", profile);
  for (const Files& files : {prusa, bambu}) {
    const auto metadata = Read(files);
    ASSERT_TRUE(metadata.ok()) << metadata.status();
    EXPECT_EQ(metadata->profiles.at(1), "0;0.2;5;0.1");
  }
}

TEST(FilesWithoutEffect, AreNamedInWords) {
  Files files = PrusaFiles();
  files.emplace_back("Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
                     "<custom_gcodes_per_print_z>\n</custom_gcodes_per_print_z>");
  files.emplace_back("Metadata/custom_gcode_per_layer.xml",
                     "<plate><layer top_z=\"1\" type=\"2\"/></plate>");
  const std::string bytes = Zipped(files);
  const auto idle = FilesWithoutEffect(*Archive::Open(bytes));
  ASSERT_TRUE(idle.ok()) << idle.status();
  EXPECT_THAT(*idle, testing::ElementsAre("changes of tool at certain heights"));
}

// SuperSlicer writes its settings a second time for PrusaSlicer, without its own special settings.
TEST(FilesWithoutEffect, AreFlowsOfObjectsOfSuperSlicers) {
  Files files = PrusaFiles();
  files.emplace_back("Metadata/SuperSlicer_model.config",
                     "<config><object id=\"1\"><metadata type=\"object\" "
                     "key=\"print_extrusion_multiplier\" value=\"99.5%\"/></object></config>");
  const std::string bytes = Zipped(files);
  EXPECT_THAT(
      *FilesWithoutEffect(*Archive::Open(bytes)),
      testing::ElementsAre("flows of single objects (print_extrusion_multiplier of SuperSlicer)"));
}

TEST(FilesWithoutEffect, AreAllSettingsOfCura) {
  Files files = CubeFiles();
  files.emplace_back("Cura/Ender.global.cfg", "[general]\n");
  files.emplace_back("Cura/pla.xml.fdm_material", "<fdmmaterial/>");
  const std::string bytes = Zipped(files);
  EXPECT_THAT(*FilesWithoutEffect(*Archive::Open(bytes)),
              testing::ElementsAre("settings of this Cura project, which are not read (use a "
                                   "profile with --config)"));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::metadata_test
