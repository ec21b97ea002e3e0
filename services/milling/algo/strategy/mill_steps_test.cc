#include "services/milling/algo/strategy/mill_steps.h"

#include <gtest/gtest.h>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::mill_steps_test {
namespace {

void ExpectSame(const MilledStep& a, const MilledStep& b) {
  EXPECT_EQ(a.step, b.step);
  ASSERT_EQ(a.areas.size(), b.areas.size());
  for (size_t i = 0; i < a.areas.size(); ++i) {
    EXPECT_EQ(a.areas[i].area, b.areas[i].area);
    EXPECT_EQ(a.areas[i].passes, b.areas[i].passes);
  }
  EXPECT_EQ(a.runs, b.runs);
}

/// A step's result depends neither on the division into ranges nor on the threads.
TEST(MillSteps, DoNotDependOnRanges) {
  for (const std::string_view text : {"ball:1", "cyl:1", "bullcone:0.6:0.2:20:1"}) {
    const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor(text));
    const std::vector<MilledStep> whole = AllSteps(job);
    ASSERT_EQ(whole.size(), job.steps.size());
    const std::vector<size_t> cuts = {0, 1, 2, 5, 6, 13, 20, 21, whole.size() - 3, whole.size()};
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      const auto range = MillSteps(job, cuts[i], cuts[i + 1], {}, 3);
      ASSERT_TRUE(range.ok());
      ASSERT_EQ(range->size(), cuts[i + 1] - cuts[i]);
      for (size_t k = 0; k < range->size(); ++k) ExpectSame((*range)[k], whole[cuts[i] + k]);
    }
  }
}

TEST(MillSteps, StopWhenCancelled) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1"));
  for (const size_t first : {size_t{0}, job.steps.size() - 1}) {
    const auto steps = MillSteps(job, first, first + 1, CancelToken([] { return true; }));
    EXPECT_EQ(steps.status().code(), absl::StatusCode::kCancelled);
  }
}

}  // namespace
}  // namespace slicefarm::milling::mill_steps_test
