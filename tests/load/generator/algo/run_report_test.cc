#include "tests/load/generator/algo/run_report.h"

#include <gtest/gtest.h>

namespace slicefarm::load::run_report_test {
namespace {

RunReport ReportOf(double seconds, int64_t last_end_ns, int ok, int failed) {
  RunLog log;
  for (int i = 0; i < ok; ++i) log.Ended(0, last_end_ns, {});
  for (int i = 0; i < failed; ++i) log.Ended(0, last_end_ns, {.status = absl::InternalError("")});
  RunReport report;
  report.seconds = seconds;
  report.record = log.Take();
  return report;
}

TEST(RunReport, AchievedCountsWhatWentWell) {
  EXPECT_DOUBLE_EQ(ReportOf(10, 9'000'000'000, 50, 50).AchievedRps(), 5);
}

// Otherwise, requests that a server completes after the load would count as a sustained rate.
TEST(RunReport, TheRunLastsUntilItsLastRequestEnds) {
  const RunReport report = ReportOf(10, 40'000'000'000, 100, 0);
  EXPECT_DOUBLE_EQ(report.TotalSeconds(), 40);
  EXPECT_DOUBLE_EQ(report.AchievedRps(), 2.5);
}

TEST(RunReport, ALoopWithoutARateIsClosed) {
  RunReport report;
  EXPECT_FALSE(report.open_loop());
  report.intended_rps = 0.5;
  EXPECT_TRUE(report.open_loop());
}

}  // namespace
}  // namespace slicefarm::load::run_report_test
