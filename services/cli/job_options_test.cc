#include "services/cli/job_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "services/cli/files.h"

namespace slicefarm::cli {
namespace {

using config::Setting;
using config::Source;
using testing::ElementsAre;
using testing::HasSubstr;

std::string TempFile(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "/job_options_" + name;
  EXPECT_TRUE(WriteFile(path, text).ok());
  return path;
}

TEST(GivenSettings, PutsFilesBeforeHand) {
  JobOptions options;
  options.config_files = {TempFile("a.ini", "perimeters = 2\n"),
                          TempFile("b.ini", "perimeters = 3\n")};
  options.sets = {"perimeters=4", " start_gcode = G28 ; a=b"};
  const auto settings = GivenSettings(options);
  ASSERT_TRUE(settings.ok()) << settings.status();
  EXPECT_THAT(*settings, ElementsAre(Setting{"perimeters", "2", Source::kProfile},
                                     Setting{"perimeters", "3", Source::kProfile},
                                     Setting{"perimeters", "4", Source::kRequest},
                                     Setting{"start_gcode", " G28 ; a=b", Source::kRequest}));
}

TEST(GivenSettings, NamesTheFileThatIsWrong) {
  JobOptions options;
  options.config_files = {TempFile("bundle.ini", "[print:x]\n")};
  const auto settings = GivenSettings(options);
  ASSERT_FALSE(settings.ok());
  EXPECT_EQ(DetailOf(settings.status()).reason, Reason::kSettingMalformed);
  EXPECT_THAT(std::string(settings.status().message()), HasSubstr("bundle.ini: line 1"));
  options.config_files = {"/does/not/exist.ini"};
  EXPECT_EQ(DetailOf(GivenSettings(options).status()).reason, Reason::kRequestMalformed);
}

TEST(GivenSettings, WantsAnEqualsSign) {
  for (const char* text : {"perimeters", "=3", ""}) {
    JobOptions options;
    options.sets = {text};
    EXPECT_EQ(DetailOf(GivenSettings(options).status()).reason, Reason::kRequestMalformed) << text;
  }
}

TEST(GivenSettings, AreUtf8) {
  JobOptions options;
  options.sets = {"start_gcode=; M\xfcller"};
  const auto settings = GivenSettings(options);
  EXPECT_EQ(DetailOf(settings.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(settings.status()).metadata["setting"], "start_gcode");
}

TEST(ReadModel, MakesANameThatCanBePrinted) {
  JobOptions options;
  options.model = TempFile("M\xfcll\ner \xc3\xa4.stl", "solid");
  const auto model = ReadModel(options);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->name, "job_options_M?ll?er \xc3\xa4.stl");
}

TEST(GivenPlacement, IsTheModelAsItIsByDefault) {
  const auto placement = GivenPlacement({});
  ASSERT_TRUE(placement.ok());
  EXPECT_EQ(*placement, Placement{});
}

TEST(GivenPlacement, ReadsUnitsScaleRotationAndCenters) {
  JobOptions options;
  options.units = "inch";
  options.scale = "2,1,0.5";
  options.rotate = "90, 0,-45";
  options.centers = {"50,60", "150,60.5"};
  const auto placement = GivenPlacement(options);
  ASSERT_TRUE(placement.ok()) << placement.status();
  EXPECT_DOUBLE_EQ(placement->unit_mm, 25.4);
  EXPECT_THAT(placement->scale, ElementsAre(2, 1, 0.5));
  EXPECT_THAT(placement->rotate_deg, ElementsAre(90, 0, -45));
  EXPECT_THAT(placement->centers,
              ElementsAre(Point{50'000'000, 60'000'000}, Point{150'000'000, 60'500'000}));
  options.scale = "1.5";
  EXPECT_THAT(GivenPlacement(options)->scale, ElementsAre(1.5, 1.5, 1.5));
}

TEST(GivenPlacement, RefusesNonsenseNamingTheOption) {
  const auto refused = [](const std::string& option, JobOptions options) {
    const auto placement = GivenPlacement(options);
    ASSERT_FALSE(placement.ok()) << option;
    EXPECT_EQ(DetailOf(placement.status()).reason, Reason::kRequestMalformed);
    EXPECT_THAT(std::string(placement.status().message()), HasSubstr(option));
  };
  for (const char* scale : {"0", "-1", "a", "1,2", "1,2,3,4", "1,2,0", "nan"}) {
    JobOptions options;
    options.scale = scale;
    refused("--scale", options);
  }
  for (const char* rotate : {"1", "1,2", "1,2,x", "1,,2"}) {
    JobOptions options;
    options.rotate = rotate;
    refused("--rotate", options);
  }
  for (const char* center : {"1", "1,2,3", "a,b", "1e9,0"}) {
    JobOptions options;
    options.centers = {center};
    refused("--center", options);
  }
}

TEST(ReadModel, TakesTheNameWithoutFolders) {
  JobOptions options;
  options.model = TempFile("cube.stl", "solid");
  const auto model = ReadModel(options);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->name, "job_options_cube.stl");
  EXPECT_EQ(model->bytes, "solid");
}

}  // namespace
}  // namespace slicefarm::cli
