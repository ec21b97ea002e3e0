#include "services/motion/algo/toolpath/lifts.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::lifts_test {
namespace {

TEST(RisesAfter, IsWhatTheSettingSays) {
  struct Case {
    LiftAfter after;
    bool inside, first_layer, top;
  };
  for (const Case& each :
       {Case{LiftAfter::kAll, true, true, true}, Case{LiftAfter::kTop, false, false, true},
        Case{LiftAfter::kBottom, false, true, false},
        Case{LiftAfter::kTopAndBottom, false, true, true}}) {
    EXPECT_EQ(RisesAfter(each.after, false, false), each.inside);
    EXPECT_EQ(RisesAfter(each.after, true, false), each.first_layer);
    EXPECT_EQ(RisesAfter(each.after, false, true), each.top);
  }
}

TEST(LiftsToStart, KnowsNothingOfTops) {
  RetractionOptions retraction;
  retraction.lift_mm = 0.4;
  retraction.lift_after = LiftAfter::kTop;
  const LayerFrame first{0, 200'000, 200'000}, later{3, 800'000, 200'000};
  EXPECT_TRUE(LiftsIn(retraction, later));
  EXPECT_FALSE(LiftsToStart(retraction, later));
  retraction.lift_after = LiftAfter::kTopAndBottom;
  EXPECT_TRUE(LiftsToStart(retraction, first));
  EXPECT_FALSE(LiftsToStart(retraction, later));
  retraction.lift_after = LiftAfter::kAll;
  EXPECT_TRUE(LiftsToStart(retraction, later));
  retraction.lift_mm = 0;
  EXPECT_FALSE(LiftsToStart(retraction, later));
}

}  // namespace
}  // namespace slicefarm::motion::lifts_test
