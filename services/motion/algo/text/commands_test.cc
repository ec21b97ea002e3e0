#include "services/motion/algo/text/commands.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::commands_test {
namespace {

TEST(Commands, AreWholeWordsAtTheStartOfALine) {
  EXPECT_TRUE(Commands("G28\n  M104 S0", {"M104", "M109"}));
  EXPECT_TRUE(Commands("M109", {"M104", "M109"}));
  EXPECT_TRUE(Commands("M104;", {"M104"}));
  EXPECT_FALSE(Commands("M1045 S0", {"M104"}));
  EXPECT_FALSE(Commands("; M104 S0", {"M104"}));
  EXPECT_FALSE(Commands("", {"M104"}));
}

}  // namespace
}  // namespace slicefarm::motion::commands_test
