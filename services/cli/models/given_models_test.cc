#include "services/cli/models/given_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "services/cli/console/files.h"
#include "services/cli/models/model_arguments.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::cli::given_models_test {
namespace {

namespace threemf = slicing::threemf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string TempFile(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "/given_models_" + name;
  std::ofstream(path) << text;  // WriteFile does not replace a file that the program has read
  return path;
}

/// Returns options with a model.
JobOptions WithModel() {
  JobOptions options;
  options.models = {TempFile("cube.stl", "solid")};
  return options;
}

TEST(ReadModels, MakesANameThatCanBePrinted) {
  JobOptions options;
  options.models = {TempFile("M\xfcll\ner \xc3\xa4.stl", "solid")};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->files[0].name, "given_models_M?ll?er \xc3\xa4.stl");
  EXPECT_EQ(models->plates[0].objects[0].name, models->files[0].name);
}

TEST(ReadModels, TakesTheNameWithoutFolders) {
  const auto models = ReadModels(WithModel());
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->files.size(), 1);
  EXPECT_EQ(models->files[0].name, "given_models_cube.stl");
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
  for (const char* copies :
       {"", "3", "given_models_cube.stl", "given_models_cube.stl=", "given_models_cube.stl=0",
        "given_models_cube.stl=-1", "given_models_cube.stl=1.5", "given_models_cube.stl=x",
        "given_models_cube.stl=1001", "other.stl=2"}) {
    JobOptions options = WithModel();
    options.copies = {copies};
    ExpectRefused(options, "--copies");
  }
  for (const char* set : {"", "perimeters=2", "given_models_cube.stl", "given_models_cube.stl=2",
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
  ASSERT_EQ(models->plates[0].objects.size(), 3);
  EXPECT_EQ(models->plates[0].objects[0].parts[0].mesh.file, 0);
  EXPECT_EQ(models->plates[0].objects[1].parts[0].mesh.file, 1);
  EXPECT_EQ(models->plates[0].objects[1].name, "given_models_b.stl");
  EXPECT_EQ(models->plates[0].objects[2].parts[0].mesh.file, 0);
}

TEST(ReadModels, CopiesAndSettingsAreOfTheModelThatTheyName) {
  const std::string a = TempFile("a.stl", "solid a");
  const std::string b = TempFile("b.stl", "solid b");
  JobOptions options;
  options.models = {a, b};
  options.copies = {"given_models_b.stl=3"};
  options.object_sets = {a + ":fill_density=40%", "given_models_a.stl:perimeters=4",
                         "given_models_b.stl:seam_position=rear"};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->plates[0].objects[0].instances.size(), 1);
  EXPECT_THAT(models->plates[0].objects[0].settings,
              ElementsAre(Setting{"fill_density", "40%"}, Setting{"perimeters", "4"}));
  EXPECT_EQ(models->plates[0].objects[1].instances.size(), 3);
  EXPECT_THAT(models->plates[0].objects[1].settings, ElementsAre(Setting{"seam_position", "rear"}));
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
  EXPECT_EQ(models->plates[0].objects[0].instances.size(), 1);
  EXPECT_TRUE(models->plates[0].objects[0].settings.empty());
  EXPECT_EQ(models->plates[0].objects[1].instances.size(), 2);
  EXPECT_THAT(models->plates[0].objects[1].settings, ElementsAre(Setting{"perimeters", "4"}));
}

TEST(ReadModels, CopiesHaveNoPlaceThatIsGiven) {
  JobOptions options = WithModel();
  options.copies = {"given_models_cube.stl=2"};
  options.centers = {"50,60"};
  ExpectRefused(options, "--center");
}

/// Returns options with a project. PrusaSlicer's has two copies of a bracket, one of them not
/// printed, and a block. Bambu Studio's has two plates.
JobOptions WithProject(const threemf::Files& files) {
  JobOptions options;
  options.models = {TempFile("plate.3mf", threemf::Zipped(files))};
  return options;
}

TEST(ReadModels, TakesAProjectAsItIs) {
  const auto models = ReadModels(WithProject(threemf::PrusaFiles()));
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->files.size(), 1);
  EXPECT_EQ(models->files[0].format, MeshFormat::k3mf);
  ASSERT_EQ(models->plates[0].objects.size(), 2);
  const SceneObject& bracket = models->plates[0].objects[0];
  EXPECT_EQ(bracket.name, "Bracket");
  ASSERT_EQ(bracket.instances.size(), 1);
  EXPECT_TRUE(bracket.instances[0].placed);
  EXPECT_EQ(bracket.instances[0].to_plate(0, 3), 50);
  ASSERT_EQ(bracket.parts.size(), 2);
  EXPECT_EQ(bracket.parts[1].role, PartRole::kModifier);
  EXPECT_EQ(models->plates[0].objects[1].ranges.size(), 1);
  EXPECT_THAT(models->plates[0].settings,
              testing::Contains(Setting{"layer_height", "0.2", Source::kProfile}));
  EXPECT_FALSE(models->plates[0].without_effect.empty());
  EXPECT_THAT(models->plates[0].warnings, testing::Each(testing::EndsWith(": without effect")));
}

TEST(ReadModels, AsksForOnePlateOfSeveral) {
  JobOptions options = WithProject(threemf::BambuFiles());
  ExpectRefused(options, "choose from 1 (\"left\"), 2");
  options.plate = 3;
  ExpectRefused(options, "no plate 3");
  for (options.plate = 1; options.plate <= 2; ++options.plate) {
    const auto models = ReadModels(options);
    ASSERT_TRUE(models.ok()) << models.status();
    ASSERT_EQ(models->plates[0].objects.size(), 1);
    ASSERT_EQ(models->plates[0].objects[0].instances.size(), 1);
    EXPECT_EQ(models->plates[0].objects[0].instances[0].to_plate(0, 3), 128) << options.plate;
  }
  options = WithModel();
  options.plate = 1;
  ExpectRefused(options, "--plate");
}

TEST(ReadModels, AllPlatesAreAPlateEach) {
  JobOptions options = WithProject(threemf::BambuFiles());
  options.plates = true;
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_EQ(models->files.size(), 1);
  ASSERT_EQ(models->plates.size(), 2);
  for (const GivenPlate& plate : models->plates) EXPECT_EQ(plate.objects.size(), 1);
}

TEST(PutOnBeds, CopiesTakeAsManyPlatesAsNeeded) {
  JobOptions options = WithProject(threemf::CubeFiles());  // cube of 10 mm
  options.plates = true;
  options.copies = {"given_models_plate.3mf=20"};
  const std::vector<Setting> bed = {{"bed_shape", "0x0,50x0,50x50,0x50"}};
  auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->plates.size(), 1);
  PutOnBeds(options, bed, *models);
  EXPECT_TRUE(CheckPlates(*models).ok()) << CheckPlates(*models);
  ASSERT_GE(models->plates.size(), 2);
  size_t copies = 0;
  for (const GivenPlate& plate : models->plates) copies += plate.objects[0].instances.size();
  EXPECT_EQ(copies, 20);
}

TEST(CheckPlates, NamesThePlate) {
  GivenModels models;
  models.plates.push_back({.refused = Malformed("why")});
  EXPECT_EQ(CheckPlates(models).message(), "why");
  models.plates.insert(models.plates.begin(), GivenPlate{.number = 2});
  EXPECT_EQ(CheckPlates(models).message(), "plate 2: why") << "of models, by the result's number";
  models.plates[1].number = 7;
  EXPECT_EQ(CheckPlates(models).message(), "plate 7: why");
}

TEST(CheckOutputs, SeveralPlatesNeedFiles) {
  JobOptions options;
  options.plates = true;
  EXPECT_TRUE(CheckOutputs(options, "out.gcode").ok());
  EXPECT_FALSE(CheckOutputs(options, "-").ok());
}

TEST(NamedOutput, IsAFolderOrThatOfTheModel) {
  const TempDirectory folder;
  JobOptions options;
  options.models = {"models/part.stl"};
  EXPECT_EQ(NamedOutput(options, "a/b.gcode", "name.gcode", 0), "a/b.gcode");
  EXPECT_EQ(NamedOutput(options, "", "name.gcode", 0), "models/name.gcode");
  EXPECT_EQ(NamedOutput(options, folder.path(), "name.gcode", 0), folder.path() + "/name.gcode");
  EXPECT_EQ(NamedOutput(options, "-", "name.gcode", 0), "-");
  options.plates = true;
  EXPECT_EQ(NamedOutput(options, folder.path(), "name.bgcode", 1),
            folder.path() + "/name-2.bgcode");
}

TEST(ReadModels, DoesNotMoveWhatAProjectHasPlaced) {
  JobOptions options = WithProject(threemf::PrusaFiles());
  options.rotate_z_deg = 90;
  ExpectRefused(options, "--arrange");
  options.arrange = true;
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_FALSE(models->plates[0].objects[0].instances[0].placed);
  EXPECT_NEAR(models->plates[0].objects[0].instances[0].to_plate(1, 0), 1, 1e-12);
  options = WithProject(threemf::PrusaFiles());
  options.units = "inch";
  ExpectRefused(options, "--units");
  options = WithProject(threemf::PrusaFiles());
  options.copies = {"Bracket=2"};
  ExpectRefused(options, "--arrange");
}

TEST(ReadModels, AProjectOfACadProgramIsPlacedLikeAnyModel) {
  JobOptions options = WithProject(threemf::CubeFiles());
  options.copies = {"given_models_plate.3mf=3"};
  auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->plates[0].objects[0].instances.size(), 3);
  EXPECT_FALSE(models->plates[0].objects[0].instances[2].placed);
  options.copies = {};
  options.scale = "2";
  options.centers = {"50,60", "80,60"};
  models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  ASSERT_EQ(models->plates[0].objects[0].instances.size(), 2);
  const Instance& second = models->plates[0].objects[0].instances[1];
  EXPECT_TRUE(second.placed && second.by_middle);
  EXPECT_EQ(second.to_plate(0, 3), 80);
  EXPECT_EQ(second.to_plate(0, 0), 2);
}

TEST(ReadModels, ObjectsOfAProjectCanBeNamed) {
  JobOptions options = WithProject(threemf::PrusaFiles());
  options.object_sets = {"Block:perimeters=5", "given_models_plate.3mf:fill_density=40%"};
  const auto models = ReadModels(options);
  ASSERT_TRUE(models.ok()) << models.status();
  EXPECT_THAT(models->plates[0].objects[0].settings,
              testing::Contains(Setting{"fill_density", "40%"}));
  EXPECT_THAT(models->plates[0].objects[1].settings,
              ElementsAre(Setting{"perimeters", "5"}, Setting{"fill_density", "40%"}));
}

TEST(ReadModels, WhatIsNamed3mfMustBeOne) {
  JobOptions options;
  options.models = {TempFile("page.3mf", "<!DOCTYPE html>\n" + std::string(200, ' '))};
  const auto models = ReadModels(options);
  EXPECT_EQ(DetailOf(models.status()).reason, Reason::kMeshFormatUnknown);
  EXPECT_THAT(std::string(models.status().message()), HasSubstr("page.3mf"));
  EXPECT_THAT(std::string(models.status().message()), HasSubstr("not a 3MF project"));
}

TEST(ReadModels, DamagedProjectsAreNamed) {
  JobOptions options;
  options.models = {TempFile("bad.3mf", "PK\x03\x04 and nothing more")};
  const auto models = ReadModels(options);
  EXPECT_EQ(DetailOf(models.status()).reason, Reason::kMeshTruncated);
  EXPECT_THAT(std::string(models.status().message()), HasSubstr("bad.3mf"));
}

}  // namespace
}  // namespace slicefarm::cli::given_models_test
