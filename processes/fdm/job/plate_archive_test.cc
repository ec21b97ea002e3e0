#include "processes/fdm/job/plate_archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/text_format_test.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::coordinator::plate_archive_test {
namespace {

using testing::ElementsAre;

TEST(TakePlatePictures, LeavesThePicturesOfTheProgram) {
  std::vector<Thumbnail> thumbnails = {{16, 16, "a"},
                                       {512, 512, "b", PictureFormat::kPng, PictureRole::kPlate},
                                       {300, 300, "c"},
                                       {512, 512, "d", PictureFormat::kPng, PictureRole::kPick}};
  const std::vector<Thumbnail> pictures = TakePlatePictures(thumbnails);
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_EQ(pictures[1].data, "d");
  ASSERT_EQ(thumbnails.size(), 2u);
  EXPECT_EQ(thumbnails[1].data, "c");
}

TEST(ArchivedPlate, HasTheFactsOfTheJob) {
  ProgramSummary summary;
  summary.layers.resize(2);
  summary.layers[1].frame.height_nm = 150'000;
  summary.total.features[static_cast<size_t>(Feature::kSupport)].length_mm = 1;
  summary.copies = {{{"a", 0, 0, 1}, MakePolygonsOrDie("(1 2, 11 2, 11 22)")[0].outer, {}},
                    {{"b", 1, 0, 1}, {}, {}}};
  summary.settings_text =
      "layer_height = 0.15\ntemperature = 215\nunknown = 1\n"
      "filament_id = GFA00\ncurr_bed_type = Textured PEI Plate\n";
  JobReport report;
  report.file_name = "part_PLA.gcode.3mf";
  report.print_time_s = 100;
  report.layer_count = 2;
  report.filament = {10, 20, 30, 40};
  FdmSettings settings;
  settings.tools.resize(1);
  settings.tools[0].filament_type = "PETG";
  settings.machine.motion.labels = ObjectLabels::kFirmware;
  const gcode::ArchivedPlate plate =
      ArchivedPlateOf(summary, {.layer_s = {7, 8}}, report, settings,
                      {{512, 512, "x", PictureFormat::kPng, PictureRole::kPlate},
                       {128, 128, "y", PictureFormat::kPng, PictureRole::kPlate},
                       {512, 512, "z", PictureFormat::kPng, PictureRole::kTop}});
  EXPECT_EQ(plate.title, "part_PLA");
  EXPECT_EQ(plate.first_layer_time_s, 7);
  EXPECT_EQ(plate.layer_height_mm, 0.15);
  EXPECT_TRUE(plate.has_supports);
  EXPECT_TRUE(plate.has_labels);
  EXPECT_EQ(plate.filament_g, 30);
  EXPECT_EQ(plate.filament_id, "GFA00");
  EXPECT_EQ(plate.bed_type, "textured_plate");
  ASSERT_EQ(plate.objects.size(), 2u);
  EXPECT_EQ(plate.objects[0].id, 1);
  EXPECT_EQ(plate.objects[0].box.max_y, 22);
  EXPECT_EQ(plate.objects[0].area_mm2, 100);
  EXPECT_EQ(plate.objects[1].id, 2);
  ASSERT_EQ(plate.pictures.size(), 3u);
  EXPECT_EQ(plate.pictures[0].name, "plate_#.png");
  EXPECT_EQ(plate.pictures[1].name, "plate_#_small.png");
  EXPECT_EQ(plate.pictures[2].name, "top_#.png");
  EXPECT_THAT(plate.settings, testing::Contains(testing::Pair("layer_height", "0.15")));
  EXPECT_THAT(plate.list_settings,
              testing::Contains(testing::Pair("nozzle_temperature", ElementsAre("215"))));
  EXPECT_THAT(plate.list_settings,
              testing::Contains(testing::Pair("filament_type", ElementsAre("PETG"))));
}

}  // namespace
}  // namespace slicefarm::coordinator::plate_archive_test
