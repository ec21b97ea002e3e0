#include "processes/list/tasks.h"

#include <gtest/gtest.h>

namespace slicefarm::tasks_test {
namespace {

TEST(ChainsOver, NoStagesNoChains) { EXPECT_TRUE(ChainsOver({}).empty()); }

TEST(TaskStagesOf, EveryProcessHasSome) {
  for (const ProcessInfo& info : kProcesses)
    EXPECT_FALSE(TaskStagesOf(info.process).empty()) << info.name;
}

}  // namespace
}  // namespace slicefarm::tasks_test
