#include "common/stage/job_memory.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/geometry/text_format_test.h"

namespace slicefarm::job_memory_test {
namespace {

LayerPlan PlanWith(SectionPlan section) {
  LayerPlan plan;
  plan.sections.push_back(std::move(section));
  return plan;
}

TEST(MemoryOf, CountsEachAreaOfAPlan) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9)");
  const int64_t empty = MemoryOf(PlanWith({}));
  SectionPlan above_supports;
  above_supports.above_supports = square;
  SectionPlan curled;
  curled.curled = square;
  EXPECT_GT(MemoryOf(PlanWith(above_supports)), empty);
  EXPECT_EQ(MemoryOf(PlanWith(curled)), MemoryOf(PlanWith(above_supports)));
}

}  // namespace
}  // namespace slicefarm::job_memory_test
