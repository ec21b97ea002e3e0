#include "services/texture/algo/pattern/stroke_font.h"

#include <gtest/gtest.h>

#include <string>

namespace slicefarm::texture::stroke_font_test {
namespace {

TEST(StrokeFont, LettersAreWithinTheirBox) {
  for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+.!/")) {
    ASSERT_TRUE(HasGlyph(c)) << c;
    EXPECT_FALSE(GlyphOf(c).empty()) << c;
    for (const Stroke& stroke : GlyphOf(c)) {
      EXPECT_GE(stroke.size(), 2u) << c;
      for (const Eigen::Vector2d& p : stroke) {
        EXPECT_GE(p.minCoeff(), 0) << c;
        EXPECT_LE(p.x(), kGlyphWidth) << c;
        EXPECT_LE(p.y(), kGlyphHeight) << c;
      }
    }
  }
}

TEST(StrokeFont, ABlankHasNoStrokes) {
  EXPECT_TRUE(HasGlyph(' '));
  EXPECT_TRUE(GlyphOf(' ').empty());
  EXPECT_FALSE(HasGlyph('a'));
  EXPECT_FALSE(HasGlyph('\n'));
}

}  // namespace
}  // namespace slicefarm::texture::stroke_font_test
