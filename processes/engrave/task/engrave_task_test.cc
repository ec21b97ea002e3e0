#include "processes/engrave/task/engrave_task.h"

#include <gtest/gtest.h>

#include "processes/engrave/task/engrave_chain.h"
#include "processes/engrave/task/fake_texture_test.h"

namespace slicefarm::engrave_task_test {
namespace {

TEST(EngraveTask, IsARangeOfLayers) {
  const EngraveTask task{{3, 10}, EngraveInput{}};
  EXPECT_EQ(task.Weight(), 7);
  EXPECT_EQ(task.Label().text, "layers 3 to 9");
}

TEST(EngraveResult, IsToldByItsText) {
  EngraveResult one{.layers = {{.numbers = {}, .program = {}, .text = "a"}}, .times = {}};
  EngraveResult other = one;
  EXPECT_EQ(one.Print(), other.Print());
  EXPECT_EQ(one.ProgramBytes(), 1);
  other.layers[0].text = "b";
  EXPECT_NE(one.Print(), other.Print());
}

TEST(EngraveChain, EngravesTheRange) {
  EXPECT_EQ(EngraveChain::Over({}), nullptr);
  const FakeTexture texture;
  const auto result = EngraveChain(texture).Run({}, {{2, 4}, EngraveInput{}});
  ASSERT_TRUE(result.ok()) << result.status();
  ASSERT_EQ(result->layers.size(), 2u);
  EXPECT_EQ(result->layers[0].text, "layer 2\n");
}

}  // namespace
}  // namespace slicefarm::engrave_task_test
