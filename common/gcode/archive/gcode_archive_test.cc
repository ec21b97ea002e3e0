#include "common/gcode/archive/gcode_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/str_replace.h"
#include "common/gcode/archive/plate_texts.h"
#include "common/gcode/archive/zip_bytes.h"

namespace slicefarm::gcode::gcode_archive_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ArchivedPlate PlateOf(const std::string& gcode) {
  ArchivedPlate plate;
  plate.title = "a \"part\" & <more>\n";
  plate.gcode = gcode;
  plate.pictures = {{"plate_#.png", "large"},
                    {"plate_#_small.png", "small"},
                    {"plate_no_light_#.png", "unlit"},
                    {"top_#.png", "top"},
                    {"pick_#.png", "pick"}};
  plate.time_s = 1234.6;
  plate.layers = 3;
  plate.filament_mm = 2227.86;
  plate.filament_g = 6.754;
  plate.filament_type = "PLA";
  plate.filament_id = "GFA00";
  plate.bed_type = "textured_plate";
  plate.filament_colour = "#00AE42";
  plate.printer_model = "Bambu Lab X1 Carbon";
  plate.nozzle_mm = 0.4;
  plate.layer_height_mm = 0.2;
  plate.objects = {{1, "cube", {10, 20, 30, 40}, 400}, {2, "x&y", {50, 5, 60, 15}, 100}};
  plate.warnings = {"a <warning>"};
  plate.settings = {{"layer_height", "0.2"}};
  plate.list_settings = {{"nozzle_temperature", {"220"}}};
  return plate;
}

std::string ArchiveOrDie(const std::vector<ArchivedPlate>& plates) {
  auto archive = GcodeArchive(plates);
  EXPECT_TRUE(archive.ok()) << archive.status();
  return archive.ok() ? *std::move(archive) : "";
}

std::map<std::string, std::string> FilesOf(const std::string& archive) {
  std::map<std::string, std::string> files;
  const auto entries = ZipEntries(archive);
  EXPECT_TRUE(entries.ok()) << entries.status();
  if (!entries.ok()) return files;
  for (const ZipEntryInfo& entry : *entries) files[entry.name] = *ZipData(archive, entry);
  return files;
}

TEST(GcodeArchive, HasTheFilesOfBambuStudio) {
  const auto files = FilesOf(ArchiveOrDie({PlateOf("G28\n")}));
  std::vector<std::string> names;
  for (const auto& [name, data] : files) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("3D/3dmodel.model", "Metadata/_rels/model_settings.config.rels",
                                 "Metadata/model_settings.config", "Metadata/pick_1.png",
                                 "Metadata/plate_1.gcode", "Metadata/plate_1.gcode.md5",
                                 "Metadata/plate_1.json", "Metadata/plate_1.png",
                                 "Metadata/plate_1_small.png", "Metadata/plate_no_light_1.png",
                                 "Metadata/project_settings.config", "Metadata/slice_info.config",
                                 "Metadata/top_1.png", "[Content_Types].xml", "_rels/.rels"));
  EXPECT_EQ(files.at("Metadata/plate_1.gcode"), "G28\n");
  EXPECT_EQ(files.at("Metadata/plate_1.gcode.md5"), "BED3F671261EA5ABC6BE16B782D1C47B");
  EXPECT_EQ(files.at("Metadata/pick_1.png"), "pick");
}

TEST(GcodeArchive, TellsWhatPrintersAndFarmsShow) {
  const auto files = FilesOf(ArchiveOrDie({PlateOf("G28\n")}));
  const std::string& info = files.at("Metadata/slice_info.config");
  for (const char* text :
       {R"(key="index" value="1")", R"(key="prediction" value="1235")",
        R"(key="weight" value="6.75")", R"(key="printer_model_id" value="BL-P001")",
        R"(key="nozzle_diameters" value="0.4")",
        R"(<object identify_id="1" name="cube" skipped="false" />)",
        R"(<object identify_id="2" name="x&amp;y" skipped="false" />)",
        R"(tray_info_idx="GFA00" type="PLA" color="#00AE42" used_m="2.23" used_g="6.75")",
        R"(<warning msg="a &lt;warning&gt;")", R"(layer_ranges="0 2")"})
    EXPECT_THAT(info, HasSubstr(text));
  EXPECT_THAT(files.at("3D/3dmodel.model"), HasSubstr("a &quot;part&quot; &amp; &lt;more&gt; <"));
  const auto plate = nlohmann::json::parse(files.at("Metadata/plate_1.json"));
  EXPECT_EQ(plate["bed_type"], "textured_plate");
  EXPECT_EQ(plate["bbox_all"], nlohmann::json({10, 5, 60, 40}));
  EXPECT_EQ(plate["bbox_objects"][1]["name"], "x&y");
  EXPECT_EQ(plate["bbox_objects"][1]["id"], 2);
  const auto project = nlohmann::json::parse(files.at("Metadata/project_settings.config"));
  EXPECT_EQ(project["layer_height"], "0.2");
  EXPECT_EQ(project["nozzle_temperature"], nlohmann::json({"220"}));
}

TEST(GcodeArchive, PicturesComeFirst) {
  const auto entries = ZipEntries(ArchiveOrDie({PlateOf("a"), PlateOf("b")}));
  ASSERT_TRUE(entries.ok());
  for (size_t i = 1; i <= 10; ++i) EXPECT_TRUE((*entries)[i].name.ends_with(".png")) << i;
}

TEST(GcodeArchive, ProgramsComeBack) {
  const std::string one = ArchiveOrDie({PlateOf("G28\n")});
  EXPECT_TRUE(IsGcodeArchive(one));
  EXPECT_FALSE(IsGcodeArchive("G28\n"));
  for (const int plate : {kOnlyPlate, kFirstPlate, 1}) EXPECT_EQ(*TextOfPlate(one, plate), "G28\n");
  const std::string three = ArchiveOrDie({PlateOf("a"), PlateOf("b"), PlateOf("c")});
  EXPECT_THAT(*PlatesOf(three), ElementsAre(1, 2, 3));
  EXPECT_EQ(*TextOfPlate(three, 3), "c");
  EXPECT_EQ(*TextOfPlate(three, kFirstPlate), "a");
}

struct Wrong {
  const char* name;
  std::string archive;
  int plate;
  const char* message;
};

std::string ZipOrDie(const std::vector<ZipMember>& members) { return *ZipOf(members); }

TEST(GcodeArchive, WhatCannotBeReadIsAnError) {
  const std::string two = *GcodeArchive({PlateOf("a"), PlateOf("b")});
  const Wrong cases[] = {
      {"NoZip", "PK\x03\x04 and no more", kOnlyPlate, "damaged"},
      {"CutOff", two.substr(0, two.size() - 30), kOnlyPlate, "damaged"},
      {"WhichPlate", two, kOnlyPlate, "plates 1, 2: choose one with --plate N"},
      {"NoSuchPlate", two, 3, "plates 1, 2, but no plate 3"},
      {"Project", ZipOrDie({{"3D/3dmodel.model", "<model/>"}}), kOnlyPlate, "must be sliced"},
      {"WrongMd5",
       ZipOrDie({{"Metadata/plate_1.gcode", "G28"}, {"Metadata/plate_1.gcode.md5", "0123"}}), 1,
       "MD5"},
      {"NoNumber", ZipOrDie({{"Metadata/plate_x.gcode", "G28"}, {"Metadata/plate_.gcode", ""}}), 1,
       "must be sliced"},
      {"HugeNumber", ZipOrDie({{"Metadata/plate_99999999999.gcode", "G28"}}), 1, "must be sliced"},
  };
  for (const Wrong& wrong : cases) {
    const auto text = TextOfPlate(wrong.archive, wrong.plate);
    ASSERT_FALSE(text.ok()) << wrong.name;
    EXPECT_EQ(text.status().code(), absl::StatusCode::kInvalidArgument) << wrong.name;
    EXPECT_THAT(std::string(text.status().message()), HasSubstr(wrong.message)) << wrong.name;
  }
}

TEST(GcodeArchive, ReadsArchivesWithoutMd5AndInLowerCase) {
  EXPECT_EQ(*TextOfPlate(ZipOrDie({{"Metadata/plate_2.gcode", "G28\n"}}), kOnlyPlate), "G28\n");
  EXPECT_EQ(
      *TextOfPlate(ZipOrDie({{"Metadata/plate_2.gcode", "G28\n"},
                             {"Metadata/plate_2.gcode.md5", "bed3f671261ea5abc6be16b782d1c47b\n"}}),
                   2),
      "G28\n");
}

TEST(JoinedArchive, IsTheArchiveOfAllPlates) {
  const std::vector<ArchivedPlate> plates = {PlateOf("a"), PlateOf("b"), PlateOf("c")};
  std::vector<std::string> archives;
  for (const ArchivedPlate& plate : plates) archives.push_back(ArchiveOrDie({plate}));
  const auto joined = JoinedArchive(archives);
  ASSERT_TRUE(joined.ok()) << joined.status();
  EXPECT_EQ(FilesOf(*joined), FilesOf(ArchiveOrDie(plates)));
  EXPECT_FALSE(JoinedArchive({}).ok());
  EXPECT_FALSE(JoinedArchive({archives[0], *joined}).ok()) << "has several plates";
  EXPECT_FALSE(JoinedArchive({ZipOrDie({{"Metadata/plate_1.gcode", "G28"}})}).ok());
}

// Found by fuzz_archive: the joined archive had no program.
TEST(JoinedArchive, NeedsTheProgramOfEachPlate) {
  const std::string renamed =
      absl::StrReplaceAll(ArchiveOrDie({PlateOf("a")}), {{"plate_1.gcode", "plate-1.gcode"}});
  const auto joined = JoinedArchive({renamed});
  EXPECT_EQ(joined.status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(PlateTexts, OnlyBambuLabsPrintersHaveAnId) {
  EXPECT_EQ(PrinterModelId("Bambu Lab A1 mini"), "N1");
  EXPECT_EQ(PrinterModelId("Prusa MK4"), "");
}

}  // namespace
}  // namespace slicefarm::gcode::gcode_archive_test
