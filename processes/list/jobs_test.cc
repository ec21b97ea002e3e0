#include "processes/list/jobs.h"

#include <gtest/gtest.h>

#include "common/stage/exposure_stage.h"
#include "common/stage/milling_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::jobs_test {
namespace {

/// Returns a stage that is never called. Tests use only its address.
template <class Stage>
const Stage* Somewhere() {
  static const int place = 0;
  return reinterpret_cast<const Stage*>(&place);
}

TEST(JobsOver, AreOfTheProcessesWhoseStagesAreThere) {
  EXPECT_TRUE(JobsOver({}, "").empty());
  EXPECT_TRUE(JobsOver({.slicing = Somewhere<SlicingStage>()}, "").empty());
  const Stages all = {.slicing = Somewhere<SlicingStage>(),
                      .planning = Somewhere<PlanningStage>(),
                      .motion = Somewhere<MotionStage>(),
                      .exposure = Somewhere<ExposureStage>(),
                      .placing = Somewhere<PlacingStage>(),
                      .milling = Somewhere<MillingStage>(),
                      .texture = Somewhere<TextureStage>()};
  const auto jobs = JobsOver(all, "");
  ASSERT_EQ(jobs.size(), static_cast<size_t>(kProcessCount));
  for (size_t i = 0; i < jobs.size(); ++i) EXPECT_EQ(jobs[i]->process(), kProcesses[i].process);
  Stages some = all;
  some.exposure = nullptr;
  EXPECT_EQ(JobsOver(some, "").size(), 3u);
  some.milling = nullptr;
  EXPECT_EQ(JobsOver(some, "").size(), 2u);
  some.texture = nullptr;
  EXPECT_EQ(JobsOver(some, "").size(), 1u);
}

}  // namespace
}  // namespace slicefarm::jobs_test
