#include "services/planning/algo/spiral/spiral_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::spiral_planner_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kSmall = "(-5 -5, 5 -5, 5 5, -5 5)";
constexpr std::string_view kLarge = "(-5.2 -5.2, 5.2 -5.2, 5.2 5.2, -5.2 5.2)";
constexpr std::string_view kHoled = "(-5 -5, 5 -5, 5 5, -5 5) (-2 -2, -2 2, 2 2, 2 -2)";

PlanningOptions Vases() {
  PlanningOptions options;
  options.objects[0].spiral.width_nm = 450'000;
  return options;
}

/// The lowest layer is a bottom.
std::vector<SlicedLayer> Hollow(std::vector<std::string_view> outlines) {
  std::vector<SlicedLayer> layers = LayersOrDie(outlines);
  for (size_t i = 1; i < layers.size(); ++i)
    for (ObjectSection& section : layers[i].sections) section.hollow = true;
  return layers;
}

absl::StatusOr<JobPlan> Planned(const std::vector<SlicedLayer>& layers,
                                const PlanningOptions& options,
                                const std::vector<PlacedCopy>& copies) {
  auto planner = JobPlanner::Make(options, copies, {}, 1);
  if (!planner.ok()) return planner.status();
  for (const SlicedLayer& layer : layers)
    if (absl::Status ok = planner->Next(layer); !ok.ok()) return ok;
  return planner->Finish({});
}

const std::optional<SpiralTurn>& TurnOf(const JobPlan& plan, size_t layer) {
  return plan.layers[layer].sections.front().spiral;
}

TEST(SpiralPlanner, TurnsFollowEachOther) {
  const std::vector<PlacedCopy> copies = {{0, {FromMm(100), FromMm(50)}, {}}};
  const auto plan = Planned(Hollow({kSmall, kSmall, kLarge, kSmall}), Vases(), copies);
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_FALSE(TurnOf(*plan, 0));
  for (size_t i = 1; i < 4; ++i) {
    ASSERT_TRUE(TurnOf(*plan, i)) << i;
    EXPECT_EQ(TurnOf(*plan, i)->last, i == 3) << i;
    EXPECT_EQ(plan->layers[i].begins_ready, i > 1) << i;
    EXPECT_EQ(plan->layers[i].ends_ready, i < 3) << i;
    if (i == 1) continue;
    EXPECT_EQ(TurnOf(*plan, i)->from, TurnOf(*plan, i - 1)->start) << i;
    EXPECT_EQ(plan->layers[i].entry, copies[0].shift + *TurnOf(*plan, i)->from) << i;
    EXPECT_LT(Distance(*TurnOf(*plan, i)->from, TurnOf(*plan, i)->start), FromMm(.3)) << i;
  }
  EXPECT_FALSE(TurnOf(*plan, 1)->from);
  EXPECT_THAT(plan->warnings, IsEmpty());
}

TEST(SpiralPlanner, LayersThatAreNoLoopAreToldOf) {
  const auto plan = Planned(Hollow({kSmall, kSmall, kHoled, kSmall}), Vases(), {{0, {}, {}}});
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_TRUE(TurnOf(*plan, 1)->last);
  EXPECT_FALSE(TurnOf(*plan, 2));
  EXPECT_FALSE(TurnOf(*plan, 3)->from);
  EXPECT_TRUE(TurnOf(*plan, 3)->last);
  EXPECT_THAT(plan->warnings, ElementsAre(HasSubstr("1 of the 3 layers above the bottom")));
}

TEST(SpiralPlanner, ASkirtBesideItIsNoPartOfTheSpiral) {
  PlanningOptions options = Vases();
  options.skirt.loops = 1;
  options.skirt.height_layers = 2;
  const auto plan = Planned(Hollow({kSmall, kSmall, kSmall}), options, {{0, {}, {}}});
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_FALSE(TurnOf(*plan, 1));
  EXPECT_TRUE(TurnOf(*plan, 2));
}

TEST(SpiralPlanner, OneAfterTheOther) {
  const auto square_at = [](Coord x) -> Polygon {
    return {{x - FromMm(5), FromMm(-5)},
            {x + FromMm(5), FromMm(-5)},
            {x + FromMm(5), FromMm(5)},
            {x - FromMm(5), FromMm(5)}};
  };
  const std::vector<PlacedCopy> two = {{0, {}, square_at(0)},
                                       {0, {FromMm(100), 0}, square_at(FromMm(100))}};
  PlanningOptions options = Vases();
  auto plan = Planned(Hollow({kSmall, kSmall, kSmall}), options, two);
  EXPECT_THAT(plan.status().message(), HasSubstr("the plate has 2"));
  options.sequence.complete_objects = true;
  plan = Planned(Hollow({kSmall, kSmall, kSmall}), options, two);
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_TRUE(TurnOf(*plan, 2)->from);

  options.objects.push_back(options.objects[0]);
  plan =
      Planned(Hollow({kSmall, kSmall, kSmall}), options, {{0, {}, {}}, {1, {FromMm(90), 0}, {}}});
  EXPECT_THAT(plan.status().message(), HasSubstr("the plate has several"));
}

}  // namespace
}  // namespace slicefarm::planning::spiral_planner_test
