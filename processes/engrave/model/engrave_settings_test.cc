#include "processes/engrave/model/engrave_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::engrave_settings_test {
namespace {

TEST(NumbersOf, ReadsNumbersBetweenCommas) {
  EXPECT_THAT(*NumbersOf("anchor", "1,-2.5, 3", 3), testing::ElementsAre(1, -2.5, 3));
  EXPECT_TRUE(NumbersOf("anchor", "", 3)->empty());
  for (const std::string_view text : {"1,2", "1,2,x", "1,2,3,4", "1,,3"})
    EXPECT_EQ(DetailOf(NumbersOf("anchor", text, 3).status()).metadata["setting"], "anchor")
        << text;
}

TEST(CheckTexts, NamesTheSettingThatCannotBeRead) {
  EXPECT_TRUE(CheckTexts({}).ok());
  EngraveSettings settings;
  settings.lines.angle = "0,ninety";
  EXPECT_EQ(DetailOf(CheckTexts(settings)).metadata["setting"], "angle");
  settings = {};
  settings.texture.image = "&&&";
  EXPECT_EQ(DetailOf(CheckTexts(settings)).metadata["setting"], "texture_image");
}

TEST(ImageBytes, DecodesBase64) { EXPECT_EQ(*ImageBytes("mask_image", "iVBORw=="), "\x89PNG"); }

}  // namespace
}  // namespace slicefarm::engrave_settings_test
