#include "tests/load/generator/algo/seeded.h"

#include <gtest/gtest.h>

#include <set>

namespace slicefarm::load::seeded_test {
namespace {

TEST(SeededRandom, IsUniform) {
  SeededRandom random(7);
  constexpr int kDraws = 100'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double draw = random.Uniform();
    ASSERT_GE(draw, 0);
    ASSERT_LT(draw, 1);
    sum += draw;
    squares += draw * draw;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 0.005);
}

TEST(RequestId, IsAUuidOfVersion4) {
  for (uint64_t index = 0; index < 1000; ++index) {
    const std::string id = RequestId(3, index);
    ASSERT_EQ(id.size(), 36u);
    for (const int dash : {8, 13, 18, 23}) ASSERT_EQ(id[dash], '-') << id;
    ASSERT_EQ(id[14], '4') << id;
    ASSERT_NE(std::string("89ab").find(id[19]), std::string::npos) << id;
    ASSERT_EQ(id.find_first_not_of("0123456789abcdef-"), std::string::npos) << id;
  }
}

TEST(RequestId, IsAnotherForEachSeedAndIndexAndTheSameAgain) {
  std::set<std::string> ids;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    for (uint64_t index = 0; index < 100; ++index) ids.insert(RequestId(seed, index));
  }
  EXPECT_EQ(ids.size(), 10'000u);
  EXPECT_TRUE(ids.contains(RequestId(42, 17)));
}

}  // namespace
}  // namespace slicefarm::load::seeded_test
