#include "services/planning/algo/job_planner.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning::job_planner_test {
namespace {

constexpr std::string_view kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";

TEST(JobPlanner, EachPlannerAddsToTheSameSections) {
  const PlanningOptions options;
  const std::vector<PlacedCopy> copies = {{0, {FromMm(100), FromMm(50)}, {}}};
  auto planner = JobPlanner::Make(options, copies);
  ASSERT_TRUE(planner.ok());
  const auto layers = LayersOrDie({kSquare, kSquare});
  for (const SlicedLayer& layer : layers) ASSERT_TRUE(planner->Next(layer).ok());
  const auto job = planner->Finish();
  ASSERT_TRUE(job.ok());
  ASSERT_EQ(job->layers.size(), 2u);
  const LayerPlan& plan = job->layers[1];
  ASSERT_EQ(plan.sections.size(), 1u);
  EXPECT_EQ(plan.sections[0].seams.size(), 1u);
  ASSERT_TRUE(plan.begins_ready) << "the seam goes on";
  EXPECT_EQ(plan.entry, copies[0].shift + plan.sections[0].seams[0]);
  EXPECT_EQ(job->copies, (std::vector<Copy>{{0, copies[0].shift, 0}}));
}

TEST(JobPlanner, CompleteObjectsArePrintedOneAfterTheOther) {
  const auto copy_at = [](double x) {
    const Coord left = FromMm(x), right = FromMm(x + 10), top = FromMm(10);
    return PlacedCopy{0, {left, 0}, {{left, 0}, {right, 0}, {right, top}, {left, top}}};
  };
  const std::vector<PlacedCopy> copies = {copy_at(100), copy_at(0), copy_at(50)};
  for (const bool complete : {false, true}) {
    PlanningOptions options;
    options.sequence.complete_objects = complete;
    auto planner = JobPlanner::Make(options, copies);
    for (const SlicedLayer& layer : LayersOrDie({kSquare, kSquare}))
      ASSERT_TRUE(planner->Next(layer).ok());
    const auto job = planner->Finish();
    ASSERT_TRUE(job.ok()) << job.status();
    EXPECT_EQ(job->copies[0].pass, complete ? 2 : 0);
    EXPECT_EQ(job->copies[1].pass, 0);
    EXPECT_EQ(job->copies[2].pass, complete ? 1 : 0);
  }
}

TEST(JobPlanner, ErrorsOfPlannersEndThePlan) {
  PlanningOptions options;
  options.sequence.complete_objects = true;
  const std::vector<PlacedCopy> copies(2, {0, {}, {{0, 0}, {9, 0}, {0, 9}}});
  auto planner = JobPlanner::Make(options, copies);
  ASSERT_TRUE(planner->Next(LayersOrDie({kSquare})[0]).ok());
  EXPECT_EQ(DetailOf(planner->Finish().status()).reason, Reason::kObjectsCollide);
}

TEST(JobPlanner, RaftsOfCopiesOneAfterTheOtherAreOfOneHeight) {
  PlanningOptions options;
  options.objects.resize(2);
  for (ObjectPlanOptions& object : options.objects) {
    object.raft.heights.layers = 2;
    object.raft_settings = {0, 0};
  }
  const std::vector<PlacedCopy> copies = {{0, {}, {}}, {1, {FromMm(100), 0}, {}}};
  const std::vector<std::string> names = {"cup", "lid"};
  options.sequence.complete_objects = true;
  EXPECT_TRUE(JobPlanner::Make(options, copies, names).ok());
  options.objects[1].raft.heights.layers = 3;
  options.objects[1].raft_settings.push_back(0);
  const ErrorDetail detail = DetailOf(JobPlanner::Make(options, copies, names).status());
  EXPECT_EQ(detail.reason, Reason::kObjectsCollide);
  EXPECT_EQ(detail.metadata.at("first"), "cup");
  EXPECT_EQ(detail.metadata.at("second"), "lid");
  options.sequence.complete_objects = false;
  EXPECT_TRUE(JobPlanner::Make(options, copies, names).ok());
}

TEST(JobPlanner, RefusesARaftWithoutItsRows) {
  PlanningOptions options;
  options.objects[0].raft.heights.layers = 2;
  options.objects[0].raft_settings = {1};
  EXPECT_EQ(DetailOf(JobPlanner::Make(options, {}).status()).reason, Reason::kRequestMalformed);
  options.objects[0].raft_settings = {1, 1};
  EXPECT_TRUE(JobPlanner::Make(options, {}).ok());
}

TEST(JobPlanner, AdhesionIsPartOfThePlan) {
  PlanningOptions options;
  options.skirt.loops = 1;
  const std::vector<PlacedCopy> copies = {{0, {FromMm(100), FromMm(50)}, {}}};
  auto planner = JobPlanner::Make(options, copies);
  ASSERT_TRUE(planner.ok());
  ASSERT_TRUE(planner->Next(LayersOrDie({kSquare})[0]).ok());
  const auto job = planner->Finish();
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->skirt.layers, 1);
  EXPECT_EQ(job->skirt.loops.size(), 1u);
}

TEST(JobPlanner, RefusesObjectsWithoutOptions) {
  const PlanningOptions options;
  const std::vector<PlacedCopy> copies = {{1, {}, {}}};
  EXPECT_EQ(DetailOf(JobPlanner::Make(options, copies).status()).reason, Reason::kRequestMalformed);
  auto planner = JobPlanner::Make(options, {});
  SlicedLayer layer;
  for (const Stack& stack : {Stack(1), Stack(0, kPlateObject, StackKind::kRaft)}) {
    layer.sections = {SectionOrDie(0, 0, kSquare)};
    layer.sections[0].stack = stack;
    EXPECT_EQ(DetailOf(planner->Next(layer)).reason, Reason::kRequestMalformed);
  }
}

}  // namespace
}  // namespace slicefarm::planning::job_planner_test
