#include "common/geometry/rings/ring_cleaning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicefarm::ring_cleaning_test {
namespace {

struct CleaningCase {
  const char* name;
  Polygon ring;
  size_t want;
};

const Polygon kTriangle = {{0, 0}, {9, 0}, {0, 9}};

const std::vector<CleaningCase>& Cases() {
  static const auto* cases = new std::vector<CleaningCase>{
      {"Triangle", kTriangle, 3},
      {"Repeated", {{0, 0}, {0, 0}, {9, 0}, {9, 0}, {9, 0}, {0, 9}}, 3},
      {"Straight", {{0, 0}, {4, 0}, {9, 0}, {5, 4}, {0, 9}, {0, 3}}, 3},
      {"Spike", {{0, 0}, {9, 0}, {15, 0}, {9, 0}, {0, 9}}, 3},
      {"LongSpike", {{0, 0}, {9, 0}, {12, 3}, {15, 3}, {12, 3}, {9, 0}, {0, 9}}, 3},
      {"Line", {{0, 0}, {9, 0}, {4, 0}}, 0},
      {"Point", {{3, 3}, {3, 3}, {3, 3}}, 0},
      {"Two", {{0, 0}, {9, 0}}, 0},
      {"Empty", {}, 0},
      {"ThereAndBack", {{0, 0}, {9, 0}, {9, 9}, {9, 0}}, 0},
  };
  return *cases;
}

TEST(CleanedRing, LeavesTrueCornersOnly) {
  for (const CleaningCase& c : Cases()) EXPECT_EQ(CleanedRing(c.ring).size(), c.want) << c.name;
}

TEST(CleanedRing, DoesNotDependOnTheStart) {
  for (const CleaningCase& c : Cases()) {
    Polygon ring = c.ring;
    for (size_t turn = 0; turn < ring.size(); ++turn) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      Polygon clean = CleanedRing(ring);
      ASSERT_EQ(clean.size(), c.want) << c.name << turn;
      if (clean.empty()) continue;
      std::rotate(clean.begin(), std::min_element(clean.begin(), clean.end()), clean.end());
      EXPECT_EQ(clean, kTriangle) << c.name << turn;
    }
  }
}

}  // namespace
}  // namespace slicefarm::ring_cleaning_test
