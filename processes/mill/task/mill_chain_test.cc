#include "processes/mill/task/mill_chain.h"

#include <gtest/gtest.h>

#include "processes/mill/task/fake_milling_test.h"

namespace slicefarm::mill_chain_test {
namespace {

TEST(MillChain, GivesTheStageItsRange) {
  FakeMilling milling;
  const Shared<MillInput> input;
  const auto result = MillChain(milling).Run({}, {{4, 7}, MillPhase::kRoughing, 4, 3, input});
  ASSERT_TRUE(result.ok()) << result.status();
  ASSERT_EQ(result->steps.size(), 3u);
  EXPECT_EQ(result->steps[1].step, FakeMilling::AllSteps()[5]);
  milling.fails = true;
  EXPECT_EQ(MillChain(milling).Run({}, {{4, 7}, {}, 4, 3, input}).status().message(), "milling");
}

}  // namespace
}  // namespace slicefarm::mill_chain_test
