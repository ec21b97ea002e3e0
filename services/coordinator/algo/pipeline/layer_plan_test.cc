#include "services/coordinator/algo/pipeline/layer_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format.h"

namespace slicefarm::coordinator {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

std::vector<SlicedLayer> Layers(std::vector<std::string_view> texts) {
  std::vector<SlicedLayer> layers(texts.size());
  for (size_t i = 0; i < texts.size(); ++i) {
    layers[i].frame.index = static_cast<int32_t>(i);
    if (!texts[i].empty()) layers[i].objects = {{0, MakePolygonsOrDie(texts[i])}};
  }
  return layers;
}

constexpr std::string_view kTwoTowers = "(10 0, 20 0, 20 10, 10 10) ; (90 0, 100 0, 100 10, 90 10)";

TEST(PlanLayers, RearSeams) {
  const auto plans = PlanLayers(Layers({"(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 5 15)"}),
                                SeamPosition::kRear, {});
  ASSERT_TRUE(plans.ok());
  EXPECT_THAT(plans->at(0).seams, ElementsAre(Mm(0, 20), Mm(5, 15)));
}

TEST(PlanLayers, NearestHasNoSeams) {
  const auto plans = PlanLayers(Layers({kTwoTowers}), SeamPosition::kNearest, {});
  ASSERT_TRUE(plans.ok());
  EXPECT_THAT(plans->at(0).seams, IsEmpty());
}

TEST(PlanLayers, AlignedSeamsStandUpright) {
  const auto plans =
      PlanLayers(Layers({kTwoTowers, kTwoTowers, kTwoTowers}), SeamPosition::kAligned, {});
  ASSERT_TRUE(plans.ok());
  EXPECT_THAT(plans->at(0).seams, ElementsAre(Mm(10, 10), Mm(90, 10)));
  EXPECT_EQ(plans->at(1).seams, plans->at(0).seams);
  EXPECT_EQ(plans->at(2).seams, plans->at(0).seams);
}

TEST(PlanLayers, GoesToAndFroBetweenTowers) {
  const auto plans = PlanLayers(Layers({kTwoTowers, kTwoTowers, kTwoTowers, kTwoTowers}),
                                SeamPosition::kNearest, {});
  ASSERT_TRUE(plans.ok());
  for (int i = 1; i < 4; ++i) {
    const bool right = plans->at(i).entry.x >= FromMm(50);
    EXPECT_EQ(right, i % 2 == 1) << "layer " << i << " at " << ToText(plans->at(i).entry);
  }
}

TEST(PlanLayers, EmptyLayersAreSteppedOver) {
  const auto plans =
      PlanLayers(Layers({"", kTwoTowers, "", kTwoTowers}), SeamPosition::kAligned, {});
  ASSERT_TRUE(plans.ok());
  EXPECT_THAT(plans->at(2).seams, IsEmpty());
  EXPECT_EQ(plans->at(3).entry, plans->at(2).entry);
}

TEST(PlanLayers, IsCancelled) {
  const auto plans =
      PlanLayers(Layers({kTwoTowers}), SeamPosition::kRear, CancelToken([] { return true; }));
  EXPECT_TRUE(absl::IsCancelled(plans.status()));
}

}  // namespace
}  // namespace slicefarm::coordinator
