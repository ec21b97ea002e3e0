#include "services/texture/algo/paths/engrave_plan.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::engrave_plan_test {
namespace {

absl::StatusOr<EngravePlan> PlanWith(const EngraveOptions& options) {
  return PlanEngraving(MapFromAbove(FlatSquare(4, 20)),
                       *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=0.5"))),
                       std::nullopt, options);
}

TEST(LayerHeights, AreTheMiddlesOfEqualLayers) {
  EXPECT_EQ(LayerHeights(1, 0.5), (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(LayerHeights(1, 0.4).size(), 3u);
  EXPECT_EQ(LayerHeights(0.3, 0.1).size(), 3u) << "0.3 / 0.1 is a bit more than 3";
  EXPECT_EQ(LayerHeights(0.01, 5), (std::vector<double>{0.005}));
}

TEST(OffsetOf, IsAboveOrBelowTheSurface) {
  EXPECT_EQ(OffsetOf({}, 1, 0.25), 0.25);
  EXPECT_EQ(OffsetOf({.engraved = true}, 1, 0.25), -0.25);
  EXPECT_EQ(OffsetOf({.engraved = true, .outside = true}, 1, 0.25), -0.75);
  EXPECT_EQ(OffsetOf({.outside = true}, 1, 0.25), 0.25);
}

TEST(PlanEngraving, WhatIsTakenAwayAroundATextureGoesFromItsTopDown) {
  const auto plan = PlanWith({.layer_height_mm = 0.1, .outside = true});
  ASSERT_TRUE(plan.ok()) << plan.status();
  ASSERT_EQ(plan->layer_count(), 5);
  EXPECT_EQ(plan->LayerAt(0), 4);
  EXPECT_EQ(PlanWith({.layer_height_mm = 0.1})->LayerAt(0), 0);
}

TEST(PlanEngraving, RefusesOptionsOutOfRange) {
  const auto reason = [](const EngraveOptions& options) {
    return DetailOf(PlanWith(options).status());
  };
  EXPECT_EQ(reason({.layer_height_mm = 0}).metadata.at("setting"), "layer_height");
  EXPECT_EQ(reason({.lines = {{.spacing_mm = -1}}}).metadata.at("setting"), "spacing");
  EXPECT_EQ(reason({.lines = {}}).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(reason({.margin_mm = -1}).metadata.at("setting"), "margin");
  EXPECT_EQ(reason({.placement = {.scale = 0}}).metadata.at("setting"), "texture_scale");
}

}  // namespace
}  // namespace slicefarm::texture::engrave_plan_test
