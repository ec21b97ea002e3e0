#include "services/milling/algo/push/intervals.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace slicefarm::milling::intervals_test {
namespace {

TEST(IntervalSet, IsTheUnion) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    IntervalSet set;
    std::vector<Interval> all;
    for (int i = 0; i < 20; ++i) {
      const double low = static_cast<double>(random() % 100);
      all.push_back(
          {low, low + 1 + static_cast<double>(random() % 8), {static_cast<uint32_t>(i), 0}, {}});
      set.Add(all.back());
    }
    for (double x = 0.5; x < 120; x += 1) {
      bool in = false, in_set = false;
      for (const Interval& i : all) in |= i.low < x && x < i.high;
      for (const Interval& i : set.items()) in_set |= i.low < x && x < i.high;
      EXPECT_EQ(in, in_set);
      EXPECT_EQ(set.Covers(x, x), in);
    }
    for (size_t i = 1; i < set.items().size(); ++i)
      EXPECT_LT(set.items()[i - 1].high, set.items()[i].low);
    for (const Interval& i : set.items()) EXPECT_EQ(all[i.low_source.triangle].low, i.low);
  }
}

TEST(IntervalSet, ClosesWhatIsRounding) {
  IntervalSet set;
  set.Add({0, 1, {}, {}});
  set.Add({1 + 1e-10, 2, {}, {}});
  EXPECT_EQ(set.items().size(), 1u);
  set.Add({2 + 1e-7, 3, {}, {}});
  EXPECT_EQ(set.items().size(), 2u);
  EXPECT_FALSE(set.Covers(1.5, 2.5));
  EXPECT_TRUE(set.Covers(0, 2));
}

}  // namespace
}  // namespace slicefarm::milling::intervals_test
