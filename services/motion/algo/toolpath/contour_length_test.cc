#include "services/motion/algo/toolpath/contour_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::motion::contour_length_test {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

Path Wall(std::string_view points, bool closed = false, Feature feature = Feature::kPerimeter) {
  Path path = MakePathOrDie(points);
  path.closed = closed;
  path.feature = feature;
  path.widths_nm = {450'000};
  return path;
}

TEST(ContourLengths, ALoopCountsByItself) {
  EXPECT_THAT(ContourLengthsMm(std::vector{Wall("(0 0, 5 0, 5 5, 0 5)", true),
                                           Wall("(0 0, 9 0, 9 9, 0 9)", true)}),
              ElementsAre(20, 36));
}

TEST(ContourLengths, PiecesThatGoOnFromEachOtherCountTogether) {
  EXPECT_THAT(ContourLengthsMm(std::vector{Wall("(0 0, 10 0)"), Wall("(10 0, 10 20)"),
                                           Wall("(10 20, 40 20)"), Wall("(0 30, 7 30)")}),
              ElementsAre(60, 60, 60, 7));
}

TEST(ContourLengths, InfillInBetweenEndsAContour) {
  EXPECT_THAT(ContourLengthsMm(std::vector{Wall("(0 0, 10 0)"),
                                           Wall("(10 0, 10 9)", false, Feature::kSolidInfill),
                                           Wall("(10 9, 30 9)")}),
              ElementsAre(10, 9, 20));
}

// A link follows the loop, so the loop's end is missing. The link is as fast as the loop after it.
TEST(ContourLengths, LinksAreAsTheWallThatTheyLeadTo) {
  const Path inner = Wall("(0 0, 5 0, 5 5, 0 5, 0 0.2)");
  const Path link = Wall("(0 0.2, 0.5 0.5)");
  const Path next = Wall("(0.5 0.5, 50 0.5, 50 50, 0.5 50)", true);
  ASSERT_TRUE(IsLoop(inner));
  EXPECT_THAT(ContourLengthsMm(std::vector{inner, link, next}),
              ElementsAre(DoubleEq(19.8), DoubleEq(198), DoubleEq(198)));
}

}  // namespace
}  // namespace slicefarm::motion::contour_length_test
