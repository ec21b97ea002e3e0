#include "services/planning/algo/conflicts/near_copies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::planning::near_copies_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Point At(double x_mm) { return {FromMm(x_mm), 0}; }
Box Square(double half_mm) {
  return {{FromMm(-half_mm), FromMm(-half_mm)}, {FromMm(half_mm), FromMm(half_mm)}};
}

TEST(NearCopies, AreThoseWhoseBoxesMeet) {
  const std::vector<PlacedCopy> copies = {{0, At(0), {}}, {1, At(12), {}}, {1, At(80), {}}};
  NearCopies near(copies);
  near.Claim(0, Square(5));
  EXPECT_THAT(near.Of(0), IsEmpty()) << "nothing is known of the other";
  near.Claim(1, Square(5));
  EXPECT_THAT(near.Of(0), ElementsAre(Beside{1, At(12)}));
  EXPECT_THAT(near.Of(1), ElementsAre(Beside{0, At(-12)}));
}

TEST(NearCopies, BecomeNearAsTheyGrow) {
  const std::vector<PlacedCopy> copies = {{0, At(0), {}}, {1, At(40), {}}};
  NearCopies near(copies);
  near.Claim(0, Square(5));
  near.Claim(1, Square(5));
  EXPECT_THAT(near.Of(0), IsEmpty());
  near.Claim(1, Square(32));
  EXPECT_THAT(near.Of(0), ElementsAre(Beside{1, At(40)}));
}

TEST(NearCopies, CountOnceIfTheyStandAsOthersDo) {
  std::vector<PlacedCopy> row;
  for (int i = 0; i < 100; ++i) row.push_back({0, At(10 * i), {}});
  NearCopies near(row);
  near.Claim(0, Square(5));
  EXPECT_THAT(near.Of(0), ElementsAre(Beside{0, At(-10)}, Beside{0, At(10)}));
}

TEST(NearCopies, ThereAreNoneOfASingleCopy) {
  const std::vector<PlacedCopy> one = {{0, At(0), {}}};
  NearCopies near(one);
  near.Claim(0, Square(5));
  EXPECT_THAT(near.Of(0), IsEmpty());
}

}  // namespace
}  // namespace slicefarm::planning::near_copies_test
