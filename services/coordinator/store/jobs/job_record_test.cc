#include "services/coordinator/store/jobs/job_record.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::coordinator::job_record_test {
namespace {

TEST(JobRecord, ResultsComeBack) {
  JobResult result;
  result.tenant = "acme";
  result.gcode_sha256 = "ab";
  result.gcode_size = int64_t{1} << 40;
  result.report_sha256 = "cd";
  result.print_time_s = 0.1;
  result.filament_mm = 1.0 / 3;
  result.filament_mm3 = 2.0 / 3;
  result.filament_g = 1e-300;
  result.shares = {{{"a \"part\"", {{0.1, {1.0 / 3, 2, 3, 1e-300}}, {}}}, {"b", {}}},
                   {0.25, {4, 5, 6, 7}}};
  result.layers = 7;
  result.cached = true;
  result.cost = {"CHF", 1, 0.1, 1e-9, 1e9};
  result.warnings = {"a \"quoted\" one\n", ""};
  JobResult back;
  ASSERT_TRUE(FromJson(ToJson(result), back).ok());
  EXPECT_EQ(back, result);
}

TEST(JobRecord, ErrorsComeBack) {
  const JobError error = JobErrorOf(MakeError(absl::StatusCode::kOutOfRange, Reason::kOutOfRange,
                                              "too wide", {{"limit", "1"}, {"got", "2"}}));
  EXPECT_EQ(error.reason, "OUT_OF_RANGE");
  JobError back;
  ASSERT_TRUE(FromJson(ToJson(error), back).ok());
  EXPECT_EQ(back, error);
}

TEST(JobRecord, LabelsComeBack) {
  const std::map<std::string, std::string> labels = {{"a", "b"}, {"", "\t"}};
  std::map<std::string, std::string> back;
  ASSERT_TRUE(FromJson(ToJson(labels), back).ok());
  EXPECT_EQ(back, labels);
}

TEST(JobRecord, DamageIsAnError) {
  JobResult result;
  for (const char* text : {"", "{", "[]", "null", "{\"layers\": 3"}) {
    EXPECT_TRUE(absl::IsDataLoss(FromJson(text, result))) << text;
  }
}

TEST(JobRecord, TextThatIsNoUtf8CanBeKept) {
  const JobError error{absl::StatusCode::kInternal, "INTERNAL", "\xff\xfe", {}};
  JobError back;
  EXPECT_TRUE(FromJson(ToJson(error), back).ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::job_record_test
