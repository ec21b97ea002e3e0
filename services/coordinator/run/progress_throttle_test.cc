#include "services/coordinator/run/progress_throttle.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::progress_throttle_test {
namespace {

TEST(ProgressThrottle, TheFirstPassesAtOnce) {
  ProgressThrottle gate;
  EXPECT_TRUE(gate.Passes({.total = 500, .done = 0}, 0));
  EXPECT_EQ(gate.reported().total, 500);
}

TEST(ProgressThrottle, LaterOnesPassBySteps) {
  ProgressThrottle gate;
  gate.Passes({.total = 500, .done = 0}, 0);
  EXPECT_FALSE(gate.Passes({.total = 500, .done = 50}, 0.1)) << "too early";
  EXPECT_FALSE(gate.Passes({.total = 500, .done = 5}, 0.3)) << "too little";
  EXPECT_TRUE(gate.Passes({.total = 500, .done = 6}, 0.3));
  EXPECT_EQ(gate.reported().done, 6);
  EXPECT_FALSE(gate.Passes({.total = 500, .done = 60}, 0.4));
}

}  // namespace
}  // namespace slicefarm::coordinator::progress_throttle_test
