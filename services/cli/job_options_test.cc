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

/// Of a model.
JobOptions WithModel() {
  JobOptions options;
  options.models = {TempFile("cube.stl", "solid")};
  return options;
}

absl::StatusOr<Placement> PlacementOf(const JobOptions& options) {
  const auto models = ReadModels(options);
  if (!models.ok()) return models.status();
  return models->objects.at(0).placement;
}

TEST(ReadModels, MakesANameThatCanBePrinted) {
  JobOptions options;
  options.models = {TempFile("M\xfcll\ner \xc3\xa4.stl", "solid")};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->files[0].name, "job_options_M?ll?er \xc3\xa4.stl");
  EXPECT_EQ(models->objects[0].name, models->files[0].name);
}

TEST(ReadModels, TakesTheNameWithoutFolders) {
  const auto models = ReadModels(WithModel());
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->files.size(), 1);
  EXPECT_EQ(models->files[0].name, "job_options_cube.stl");
  EXPECT_EQ(models->files[0].bytes, "solid");
}

TEST(ReadModels, TakesTheModelAsItIsByDefault) {
  const auto placement = PlacementOf(WithModel());
  ASSERT_TRUE(placement.ok()) << placement.status();
  EXPECT_EQ(*placement, Placement{});
}

TEST(ReadModels, ReadsUnitsScaleRotationAndCenters) {
  JobOptions options = WithModel();
  options.units = "inch";
  options.scale = "2,1,0.5";
  options.rotate = "90, 0,-45";
  options.centers = {"50,60", "150,60.5"};
  const auto placement = PlacementOf(options);
  ASSERT_TRUE(placement.ok()) << placement.status();
  EXPECT_DOUBLE_EQ(placement->unit_mm, 25.4);
  EXPECT_THAT(placement->scale, ElementsAre(2, 1, 0.5));
  EXPECT_THAT(placement->rotate_deg, ElementsAre(90, 0, -45));
  EXPECT_THAT(placement->centers,
              ElementsAre(Point{50'000'000, 60'000'000}, Point{150'000'000, 60'500'000}));
  options.scale = "1.5";
  EXPECT_THAT(PlacementOf(options)->scale, ElementsAre(1.5, 1.5, 1.5));
}

void ExpectRefused(const JobOptions& options, const std::string& says) {
  const auto models = ReadModels(options);
  ASSERT_FALSE(models.ok()) << says;
  EXPECT_EQ(DetailOf(models.status()).reason, Reason::kRequestMalformed);
  EXPECT_THAT(std::string(models.status().message()), HasSubstr(says));
}

TEST(ReadModels, RefusesNonsenseNamingTheOption) {
  for (const char* scale : {"0", "-1", "a", "1,2", "1,2,3,4", "1,2,0", "nan"}) {
    JobOptions options = WithModel();
    options.scale = scale;
    ExpectRefused(options, "--scale");
  }
  for (const char* rotate : {"1", "1,2", "1,2,x", "1,,2"}) {
    JobOptions options = WithModel();
    options.rotate = rotate;
    ExpectRefused(options, "--rotate");
  }
  for (const char* center : {"1", "1,2,3", "a,b", "1e9,0"}) {
    JobOptions options = WithModel();
    options.centers = {center};
    ExpectRefused(options, "--center");
  }
  for (const char* copies : {"", "3", "job_options_cube.stl", "job_options_cube.stl=",
                             "job_options_cube.stl=0", "job_options_cube.stl=-1",
                             "job_options_cube.stl=1.5", "job_options_cube.stl=x",
                             "job_options_cube.stl=1001", "other.stl=2"}) {
    JobOptions options = WithModel();
    options.copies = {copies};
    ExpectRefused(options, "--copies");
  }
  for (const char* set : {"", "perimeters=2", "job_options_cube.stl", "job_options_cube.stl=2",
                          "other.stl:perimeters=2"}) {
    JobOptions options = WithModel();
    options.object_sets = {set};
    ExpectRefused(options, "--object-set");
  }
}

TEST(ReadModels, NamesTheFileThatIsNotThere) {
  JobOptions options = WithModel();
  options.models.push_back("/does/not/exist.stl");
  ExpectRefused(options, "/does/not/exist.stl");
}

TEST(ReadModels, ReadsAFileOnceHoweverOftenItIsNamed) {
  const std::string a = TempFile("a.stl", "solid a");
  const std::string b = TempFile("b.stl", "solid b");
  JobOptions options;
  options.models = {a, b, a};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->files.size(), 2);
  EXPECT_EQ(models->files[1].bytes, "solid b");
  ASSERT_EQ(models->objects.size(), 3);
  EXPECT_EQ(models->objects[0].file, 0);
  EXPECT_EQ(models->objects[1].file, 1);
  EXPECT_EQ(models->objects[1].name, "job_options_b.stl");
  EXPECT_EQ(models->objects[2].file, 0);
}

TEST(ReadModels, CopiesAndSettingsAreOfTheModelThatTheyName) {
  const std::string a = TempFile("a.stl", "solid a");
  const std::string b = TempFile("b.stl", "solid b");
  JobOptions options;
  options.models = {a, b};
  options.copies = {"job_options_b.stl=3"};
  options.object_sets = {a + ":fill_density=40%", "job_options_a.stl:perimeters=4",
                         "job_options_b.stl:seam_position=rear"};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->objects[0].copies, 0);
  EXPECT_THAT(models->objects[0].settings, ElementsAre(Setting{"fill_density", "40%"},
                                                       Setting{"perimeters", "4"}));
  EXPECT_EQ(models->objects[1].copies, 3);
  EXPECT_THAT(models->objects[1].settings, ElementsAre(Setting{"seam_position", "rear"}));
}

TEST(ReadModels, APathMayHoldTheSeparators) {
  const std::string odd = TempFile("odd=1:2.stl", "solid");
  const std::string start = TempFile("odd", "solid");
  JobOptions options;
  options.models = {start, odd};
  options.copies = {odd + "=2"};
  options.object_sets = {odd + ":perimeters=4"};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->objects[0].copies, 0);
  EXPECT_TRUE(models->objects[0].settings.empty());
  EXPECT_EQ(models->objects[1].copies, 2);
  EXPECT_THAT(models->objects[1].settings, ElementsAre(Setting{"perimeters", "4"}));
}

TEST(ReadModels, CopiesHaveNoPlaceThatIsGiven) {
  JobOptions options = WithModel();
  options.copies = {"job_options_cube.stl=2"};
  options.centers = {"50,60"};
  ExpectRefused(options, "--center");
}

TEST(SceneOf, HasAnInstanceForEachCopy) {
  GivenModels given;
  given.objects.resize(2);
  given.objects[0] = {"a", 1, {}, 3, {{"perimeters", "4"}}};
  given.objects[1].placement.centers = {{FromMm(50), FromMm(60)}, {FromMm(150), FromMm(60)}};
  const std::vector<SceneObject> scene = SceneOf(given);
  ASSERT_EQ(scene.size(), 2);
  EXPECT_EQ(scene[0].name, "a");
  EXPECT_EQ(scene[0].parts.at(0).mesh.file, 1);
  EXPECT_THAT(scene[0].settings, ElementsAre(Setting{"perimeters", "4"}));
  ASSERT_EQ(scene[0].instances.size(), 3);
  EXPECT_FALSE(scene[0].instances[0].placed);
  ASSERT_EQ(scene[1].instances.size(), 2);
  EXPECT_TRUE(scene[1].instances[1].placed);
  EXPECT_EQ(scene[1].instances[1].to_plate(0, 3), 150);
}

}  // namespace
}  // namespace slicefarm::cli
