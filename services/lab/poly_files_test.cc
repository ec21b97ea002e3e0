#include "services/lab/poly_files.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/measure.h"

namespace slicefarm::lab::poly_files_test {
namespace {

PolyFile Read(std::string_view text) {
  auto file = ParsePoly(text);
  EXPECT_TRUE(file.ok()) << file.status();
  return file.ok() ? *std::move(file) : PolyFile{};
}

TEST(ParsePoly, ChainsWithOrderAndComments) {
  const PolyFile file = Read(
      "# a frame\n2\n4 out # outside\n0 0\n3 3\n3 0\n0 3\n1 3 2 4\n4 in\n1 1\n1 2\n2 2\n2 1\n1 2 3 "
      "4\n");
  EXPECT_EQ(file.decimals, 0);
  ASSERT_EQ(file.islands.size(), 1u);
  EXPECT_EQ(file.islands[0].outer, (Polygon{{0, 0}, {3, 0}, {3, 3}, {0, 3}}));
  ASSERT_EQ(file.islands[0].holes.size(), 1u);
  EXPECT_EQ(Area(file.islands), 8);
}

TEST(ParsePoly, RingsAreTurned) {
  const PolyFile file = Read("1\n3 out\n0 0\n0 1\n1 0\n1 2 3\n");
  EXPECT_GT(SignedArea(file.islands[0].outer), 0);
}

TEST(ParsePoly, DecimalsAreExact) {
  const PolyFile file = Read("0.1 -2.50\n1e-3 4E2\n+7 .25\n");
  EXPECT_EQ(file.decimals, 3);
  Polygon ring = file.islands[0].outer;
  EXPECT_NE(std::find(ring.begin(), ring.end(), Point{100, -2500}), ring.end());
  EXPECT_NE(std::find(ring.begin(), ring.end(), Point{1, 400'000}), ring.end());
  EXPECT_NE(std::find(ring.begin(), ring.end(), Point{7000, 250}), ring.end());
}

TEST(ParsePoly, TooManyDigitsAreRounded) {
  const PolyFile file = Read("0 0\n1000.00000000000049 0\n0 1\n");
  EXPECT_EQ(file.decimals, 11);
  EXPECT_EQ(Bounds(file.islands).max.x, 100'000'000'000'000);
  EXPECT_EQ(Bounds(Read("0 0\n1000.00000000000549 0\n0 1\n").islands).max.x, 100'000'000'000'001);
}

TEST(ParsePoly, OutlinesNest) {
  const PolyFile file =
      Read("0.3\n0.7\n4\n0 0\n9 0\n9 9\n0 9\n4\n1 1\n8 1\n8 8\n1 8\n4\n2 2\n3 2\n3 3\n2 3\n");
  ASSERT_EQ(file.islands.size(), 2u);
  EXPECT_EQ(Area(file.islands), 81 - 49 + 1);
}

TEST(ParsePoly, OutlinesThatPassACornerTwiceAreParted) {
  // The second loop is inside the first one: by parity it is a hole.
  const PolyFile file = Read("0\n0\n7\n0 0\n9 0\n9 9\n0 9\n0 0\n3 2\n2 3\n");
  EXPECT_EQ(Area(file.islands), 81 - 2.5);
}

TEST(ParsePoly, TellsWhatIsWrong) {
  for (const char* text :
       {"", "1 2 3", "x y z", "1\n4 out\n0 0\n1 0\n1 1\n", "1\n3 out\n0 0\n1 0\n1 1\n1 2 9\n",
        "2\n3 out\n0 0\n1 0\n1 1\n1 2 3\n", "1\n3 in\n0 0\n1 0\n1 1\n1 2 3\n", "0 0\n1e30 0\n0 1\n",
        "0 0\n1.2.3 0\n0 1\n", "1\n999999999999 out\n0 0\n"}) {
    EXPECT_EQ(DetailOf(ParsePoly(text).status()).reason, Reason::kRequestMalformed) << text;
  }
}

TEST(DecimalText, InFullWithoutTrailingZeros) {
  EXPECT_EQ(DecimalText(0, 0), "0");
  EXPECT_EQ(DecimalText(0, 5), "0");
  EXPECT_EQ(DecimalText(-12, 5), "-0.00012");
  EXPECT_EQ(DecimalText(1'200'000, 5), "12");
  EXPECT_EQ(DecimalText(1'234'567, 5), "12.34567");
  EXPECT_EQ(DecimalText(-1'230'000, 5), "-12.3");
}

}  // namespace
}  // namespace slicefarm::lab::poly_files_test
