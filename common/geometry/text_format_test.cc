#include "common/geometry/text_format_test.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"

namespace slicefarm::text_format_test {
namespace {

TEST(TextFormat, RoundTrips) {
  const std::string text = "(0 0, 9.5 0, 9.5 9, 0 9) (1 1, 1 2, 2 2) ; (20 0, 21 0, 21 1)";
  EXPECT_EQ(ToText(MakePolygonsOrDie(text)), text);
}

TEST(TextFormat, TurnsRings) {
  const MultiPolygon polygons = MakePolygonsOrDie("(0 9, 9 9, 9 0, 0 0) (1 1, 2 1, 2 2)");
  EXPECT_GT(SignedArea(polygons[0].outer), 0);
  EXPECT_LT(SignedArea(polygons[0].holes[0]), 0);
}

class BadTextTest : public testing::TestWithParam<const char*> {};

TEST_P(BadTextTest, SaysWhere) {
  const auto polygons = ParseMultiPolygon(GetParam());
  ASSERT_FALSE(polygons.ok());
  EXPECT_NE(polygons.status().message().find("offset"), absl::string_view::npos)
      << polygons.status();
}

INSTANTIATE_TEST_SUITE_P(Bad, BadTextTest,
                         testing::Values("(", "0 0", "(0 0, 1)", "(0 0, 1 1)", "(0 0, 1 x, 2 2)",
                                         "(0 0, 1 0, 1 1) ;", "(0 0, 1 0, 1 1) x",
                                         "(0 0, 1e300 0, 1 1)", "(0 0, nan 0, 1 1)"));

TEST(TextFormat, EmptyTextIsNothing) { EXPECT_TRUE(MakePolygonsOrDie("  ").empty()); }

}  // namespace
}  // namespace slicefarm::text_format_test
