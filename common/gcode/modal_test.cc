#include "common/gcode/modal.h"

#include <gtest/gtest.h>

namespace slicefarm::gcode::modal_test {
namespace {

TEST(Modal, IsToldWhereItChanges) {
  Modal<int> feed;
  EXPECT_FALSE(feed.Is(0));
  EXPECT_TRUE(feed.Changes(0));
  EXPECT_FALSE(feed.Changes(0));
  EXPECT_TRUE(feed.Changes(7));
  EXPECT_TRUE(feed.Is(7));
  feed.Forget();
  EXPECT_TRUE(feed.Changes(7));
  EXPECT_FALSE(Modal<int>(3).Changes(3));
}

}  // namespace
}  // namespace slicefarm::gcode::modal_test
