#include "services/texture/algo/pattern/texture_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::texture::texture_spec_test {
namespace {

TEST(TextureSpec, TakesBackWhatItWrites) {
  for (const TextureKindInfo& info : kTextureKinds) {
    const auto standard = ParseTextureSpec(info.name);
    ASSERT_TRUE(standard.ok()) << standard.status();
    EXPECT_EQ(standard->kind, info.kind);
    const auto again = ParseTextureSpec(TextureSpecText(*standard));
    ASSERT_TRUE(again.ok()) << again.status();
    EXPECT_EQ(*again, *standard) << TextureSpecText(*standard);
  }
}

TEST(TextureSpec, ReadsParameters) {
  const auto spec = ParseTextureSpec("letters: height=0.3, pitch=8,text=Ab 1");
  ASSERT_TRUE(spec.ok()) << spec.status();
  EXPECT_EQ(spec->height_mm, 0.3);
  EXPECT_EQ(spec->pitch_mm, 8);
  EXPECT_EQ(spec->text, "AB 1");
}

struct Refusal {
  const char* text;
  Reason reason;
  const char* words;
};

TEST(TextureSpec, RefusesWhatItDoesNotKnow) {
  for (const Refusal& c : {
           Refusal{"", Reason::kSettingMalformed, "unknown texture ''; textures are bumps"},
           {"bump", Reason::kSettingMalformed, "unknown texture 'bump'"},
           {"bumps:", Reason::kSettingMalformed, "'' is not key=value"},
           {"bumps:pitch", Reason::kSettingMalformed, "'pitch' is not key=value"},
           {"bumps:octaves=2", Reason::kSettingMalformed, "bumps has no parameter 'octaves'"},
           {"bumps:pitch=wide", Reason::kSettingMalformed, "pitch is not a number: 'wide'"},
           {"bumps:pitch=0", Reason::kSettingOutOfRange, "pitch must be from 0.01 to 1000, got 0"},
           {"noise:octaves=2.5", Reason::kSettingMalformed, "octaves is not a whole number"},
           {"letters:text=", Reason::kSettingMalformed, "1 to 64 letters"},
           {"letters:text=~", Reason::kSettingMalformed, "the letter '~' is not available"},
       }) {
    const auto spec = ParseTextureSpec(c.text);
    ASSERT_FALSE(spec.ok()) << c.text;
    EXPECT_EQ(DetailOf(spec.status()).reason, c.reason) << c.text;
    EXPECT_THAT(std::string(spec.status().message()), testing::HasSubstr(c.words));
  }
}

}  // namespace
}  // namespace slicefarm::texture::texture_spec_test
