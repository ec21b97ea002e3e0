#include "processes/fdm/job/pass_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string_view>

#include "common/geometry/text_format_test.h"

namespace slicefarm::coordinator::pass_facts_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns one layer of 0.2 mm for each character of the objects. `x` is printed, `0` is empty, and
/// a blank has no section.
std::vector<SlicedLayer> Layers(const std::vector<std::string_view>& objects) {
  std::vector<SlicedLayer> layers(objects.front().size());
  std::vector<int32_t> own(objects.size(), 0);
  for (size_t i = 0; i < layers.size(); ++i) {
    layers[i].frame = {static_cast<int32_t>(i), static_cast<Coord>(i + 1) * 200'000, 200'000};
    for (size_t object = 0; object < objects.size(); ++object) {
      if (objects[object][i] == ' ') continue;
      ObjectSection section;
      section.stack = static_cast<int32_t>(object);
      section.layer = own[object]++;
      if (objects[object][i] == 'x')
        section.regions = {{.outlines = MakePolygonsOrDie("(0 0, 9 0, 9 9)")}};
      layers[i].sections.push_back(section);
    }
  }
  return layers;
}

TEST(PassesOf, OnePassNeedsNoFacts) {
  const PassPlan plan =
      PassesOf(Layers({"xxxx", "xx  "}), std::vector<Copy>{{0, {}, 0}, {1, {}, 0}});
  EXPECT_THAT(plan.passes, IsEmpty());
  EXPECT_EQ(plan.layer_count, 4);
  EXPECT_EQ(PassesOf({}, {}).layer_count, 0);
}

TEST(PassesOf, LayersAreCountedOverThePasses) {
  const auto layers = Layers({"xxxx", "xx  "});
  const PassPlan plan =
      PassesOf(layers, std::vector<Copy>{{0, {}, 1}, {0, {}, 2}, {1, {}, 0}, {1, {}, 3}});
  EXPECT_THAT(plan.passes, ElementsAre(PassFacts{0, 0, 0}, PassFacts{2, 0, 400'000},
                                       PassFacts{6, 0, 800'000}, PassFacts{10, 0, 800'000}));
  EXPECT_EQ(plan.layer_count, 12);
}

TEST(PassesOf, ObjectsHaveTheirOwnLayerHeightsAndEmptyLayers) {
  const PassPlan plan =
      PassesOf(Layers({"x x x x", "xx0xx00"}), std::vector<Copy>{{0, {}, 0}, {1, {}, 1}});
  EXPECT_THAT(plan.passes, ElementsAre(PassFacts{0, 0, 0}, PassFacts{4, 0, 1'400'000}));
  EXPECT_EQ(plan.layer_count, 9) << "four, and five with the empty one between";
}

TEST(PassesOf, ARaftBelongsToTheFirstPass) {
  const PassPlan plan =
      PassesOf(Layers({"  xx", "  xx"}), std::vector<Copy>{{0, {}, 0}, {1, {}, 1}});
  EXPECT_THAT(plan.passes, ElementsAre(PassFacts{2, 2, 0}, PassFacts{4, 2, 800'000}));
  EXPECT_EQ(plan.layer_count, 6);
}

TEST(PassesOf, CopiesThatPrintNothingHaveNoLayers) {
  const PassPlan plan =
      PassesOf(Layers({"xx", "  "}), std::vector<Copy>{{0, {}, 0}, {1, {}, 0}, {0, {}, 1}});
  EXPECT_THAT(plan.passes, ElementsAre(PassFacts{0, 0, 0}, PassFacts{2, 0, 400'000}));
  EXPECT_EQ(plan.layer_count, 4);
}

}  // namespace
}  // namespace slicefarm::coordinator::pass_facts_test
