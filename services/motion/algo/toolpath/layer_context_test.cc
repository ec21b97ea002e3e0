#include "services/motion/algo/toolpath/layer_context.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::layer_context_test {
namespace {

/// Returns layer 5 of the job: the third layer of object 1, and a layer of the plate.
OrderedLayer Layer() {
  OrderedLayer layer;
  layer.frame = {5, 1'200'000, 200'000};
  layer.blocks = {{kSkirtStack, 5, 200'000, {}}, {1, 2, 200'000, {}}};
  layer.visits = {{0, -1, 0, {}}, {1, 0, 0, {}}, {1, 1, 1, {}}};
  return layer;
}

struct Case {
  std::string name;
  size_t first, count;  ///< range of visits
  std::vector<PassFacts> passes;
  LayerContext want;
};

class ContextOfTest : public testing::TestWithParam<Case> {};

TEST_P(ContextOfTest, IsTheLayersOwn) {
  const Case& c = GetParam();
  const OrderedLayer layer = Layer();
  JobFacts facts;
  facts.passes = c.passes;
  const LayerContext context =
      ContextOf(layer, std::span(layer.visits).subspan(c.first, c.count), facts);
  EXPECT_EQ(context.pass, c.want.pass);
  EXPECT_EQ(context.index, c.want.index);
  EXPECT_EQ(context.number, c.want.number);
  EXPECT_EQ(context.print_z_nm, c.want.print_z_nm);
  EXPECT_EQ(context.top_nm, c.want.top_nm);
}

const std::vector<PassFacts> kTwo = {{3, 3, 0}, {40, 3, 8'000'000}};

INSTANTIATE_TEST_SUITE_P(
    Layers, ContextOfTest,
    testing::Values(Case{"OnePass", 0, 2, {}, {0, 5, 5, 1'200'000, 1'200'000}},
                    Case{"NothingPrinted", 0, 0, kTwo, {0, 5, 5, 1'200'000, 1'200'000}},
                    Case{"PlateAlone", 0, 1, kTwo, {0, 5, 5, 1'200'000, 1'200'000}},
                    Case{"FirstPass", 0, 2, kTwo, {0, 5, 5, 1'200'000, 1'200'000}},
                    Case{"SecondPass", 2, 1, kTwo, {1, 5, 42, 1'200'000, 8'000'000}},
                    Case{"OfAnotherLayerHeight",
                         2,
                         1,
                         {{}, {40, 0, 1'000'000}},
                         {1, 2, 42, 1'200'000, 1'200'000}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::motion::layer_context_test
