#include "services/planning/algo/seams/seam_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

std::vector<LayerPlan> Plans(const std::vector<SlicedLayer>& layers,
                             std::vector<SeamPosition> seams) {
  PlanningOptions options;
  options.objects.clear();
  for (const SeamPosition seam : seams) options.objects.push_back({seam});
  SeamPlanner planner(options);
  std::vector<LayerPlan> plans(layers.size());
  for (size_t i = 0; i < layers.size(); ++i) planner.Look(layers[i], plans[i]);
  return plans;
}

constexpr std::string_view kTwoTowers = "(10 0, 20 0, 20 10, 10 10) ; (90 0, 100 0, 100 10, 90 10)";

TEST(SeamPlanner, RearSeamsHaveTheOrderOfRings) {
  const auto plans = Plans(LayersOrDie({"(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 5 15)"}),
                           {SeamPosition::kRear});
  EXPECT_THAT(plans[0].sections[0].seams, ElementsAre(Mm(0, 20), Mm(5, 15)));
}

TEST(SeamPlanner, NearestHasNoSeams) {
  EXPECT_THAT(Plans(LayersOrDie({kTwoTowers}), {SeamPosition::kNearest})[0].sections, IsEmpty());
}

TEST(SeamPlanner, AlignedSeamsStandUpright) {
  const auto plans =
      Plans(LayersOrDie({kTwoTowers, kTwoTowers, kTwoTowers}), {SeamPosition::kAligned});
  EXPECT_THAT(plans[0].sections[0].seams, ElementsAre(Mm(10, 10), Mm(90, 10)));
  EXPECT_EQ(plans[1].sections, plans[0].sections);
  EXPECT_EQ(plans[2].sections, plans[0].sections);
}

TEST(SeamPlanner, ObjectsDoNotFollowEachOther) {
  std::vector<SlicedLayer> layers = LayersOrDie({"(0 0, 10 0, 10 10)", ""});
  layers[1].sections = {SectionOrDie(1, 0, "(0 0, 10 0, 10 10, 0 10)")};
  const auto plans = Plans(layers, {SeamPosition::kAligned, SeamPosition::kAligned});
  EXPECT_EQ(plans[1].sections[0].object, 1);
  EXPECT_THAT(plans[1].sections[0].seams, ElementsAre(Mm(0, 10)));
}

TEST(SeamPlanner, EachObjectHasItsOwnPosition) {
  std::vector<SlicedLayer> layers = LayersOrDie({kTwoTowers});
  layers[0].sections.push_back(SectionOrDie(1, 0, kTwoTowers));
  const auto plans = Plans(layers, {SeamPosition::kNearest, SeamPosition::kRear});
  ASSERT_EQ(plans[0].sections.size(), 1u);
  EXPECT_EQ(plans[0].sections[0].object, 1);
}

}  // namespace
}  // namespace slicefarm::planning
