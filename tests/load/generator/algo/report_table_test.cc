#include "tests/load/generator/algo/report_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::load::report_table_test {
namespace {

using testing::HasSubstr;
using testing::Not;

RunReport ReportOf(int64_t lag_ns) {
  RunLog log;
  log.Started(lag_ns);
  log.Ended(0, 2'000'000, {});
  log.Ended(0, 2'000'000, {.status = absl::UnavailableError("gone"), .step = "GetJob"});
  RunReport report;
  report.intended_rps = 12.5;
  report.seconds = 1;
  report.record = log.Take();
  return report;
}

TEST(ReportTable, ColumnsStandBelowTheirHeads) {
  const std::string row = TableRow(ReportOf(0));
  EXPECT_EQ(TableHeader().size(), row.find('\n') + 1);
  EXPECT_THAT(row, HasSubstr("12.5"));
  EXPECT_THAT(row, HasSubstr("2.00"));
  EXPECT_THAT(row, HasSubstr("1 x GetJob: UNAVAILABLE UNAVAILABLE\n"));
}

TEST(ReportTable, ALateGeneratorIsTold) {
  EXPECT_THAT(TableRow(ReportOf(0)), Not(HasSubstr("late")));
  EXPECT_THAT(TableRow(ReportOf(50'000'000)), HasSubstr("late"));
}

}  // namespace
}  // namespace slicefarm::load::report_table_test
