#include "services/cli/models/texture_argument.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace slicefarm::cli::texture_argument_test {
namespace {

using testing::ElementsAre;

JobOptions Engraving(TextureArguments texture) {
  JobOptions options;
  options.process = Process::kEngrave;
  options.models = {"face.obj"};
  options.texture = std::move(texture);
  return options;
}

TEST(TakeTexture, AComputedOneIsASetting) {
  JobOptions options =
      Engraving({.texture = "knurl:pitch=2", .anchor = "1,2,3", .orient = "0,1,0"});
  ASSERT_TRUE(TakeTexture(options).ok());
  EXPECT_THAT(options.sets, ElementsAre("texture=knurl:pitch=2", "anchor=1,2,3", "orient=0,1,0"));
  EXPECT_THAT(options.models, ElementsAre("face.obj"));
}

TEST(TakeTexture, ASolidIsOneMoreObject) {
  JobOptions options = Engraving({.texture = "tiles/leaf.STL"});
  ASSERT_TRUE(TakeTexture(options).ok());
  EXPECT_THAT(options.models, ElementsAre("face.obj", "tiles/leaf.STL"));
  EXPECT_THAT(options.sets, ElementsAre("texture=leaf.STL"));
}

TEST(TakeTexture, AnImageIsASetting) {
  const auto path = std::filesystem::temp_directory_path() / "texture_argument_test.png";
  std::ofstream(path) << "\x89PNG";
  JobOptions options = Engraving({.texture = path.string(), .mask = path.string()});
  ASSERT_TRUE(TakeTexture(options).ok());
  EXPECT_THAT(options.sets, ElementsAre("texture_image=iVBORw==", "mask_image=iVBORw=="));
  std::filesystem::remove(path);
}

TEST(TakeTexture, OtherMachinesTakeNone) {
  JobOptions options = Engraving({.anchor = "1,2,3"});
  options.process = Process::kMill;
  EXPECT_FALSE(TakeTexture(options).ok());
  options.texture = {};
  EXPECT_TRUE(TakeTexture(options).ok());
}

}  // namespace
}  // namespace slicefarm::cli::texture_argument_test
