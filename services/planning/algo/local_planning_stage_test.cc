#include "services/planning/algo/local_planning_stage.h"

#include <gtest/gtest.h>

#include "common/model/options/adhesion_options.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::local_planning_stage_test {
namespace {

TEST(LocalPlanning, PlansEachLayer) {
  const auto layers = LayersOrDie({"(0 0, 9 0, 9 9)", "", "(0 0, 9 0, 9 9)"});
  const std::vector<PlacedCopy> copies = {{0, {}, {}}};
  const auto plan = MakeLocalPlanning()->Plan({}, {layers, copies}, {});
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_EQ(plan->layers.size(), 3u);
  EXPECT_EQ(plan->copies.size(), 1u);
  EXPECT_TRUE(plan->stacks.empty());
}

// The things on the plate are planned after the last layer, and this may take long.
TEST(LocalPlanning, IsCancelledAfterTheLastLayer) {
  const auto layers = LayersOrDie({"(0 0, 9 0, 9 9)"});
  const std::vector<PlacedCopy> copies(4, {0, {}, {}});
  PlanningOptions brims, raft;
  brims.objects[0].brim = {.type = BrimType::kOuterOnly, .width_nm = FromMm(3)};
  raft.objects[0].raft.heights.layers = 1;
  raft.objects[0].raft_settings = {0};
  for (const PlanningOptions& options : {brims, raft}) {
    size_t polls = 0;
    StageCall call;
    call.cancel = CancelToken([&] { return ++polls > layers.size(); });
    const auto plan = MakeLocalPlanning()->Plan(call, {layers, copies}, options);
    EXPECT_TRUE(absl::IsCancelled(plan.status())) << plan.status();
  }
}

TEST(LocalPlanning, IsCancelled) {
  const auto layers = LayersOrDie({"(0 0, 9 0, 9 9)"});
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(MakeLocalPlanning()->Plan(call, {layers, {}}, {}).status()));
}

}  // namespace
}  // namespace slicefarm::planning::local_planning_stage_test
