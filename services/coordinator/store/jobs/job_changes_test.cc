#include "services/coordinator/store/jobs/job_changes.h"

#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator::job_changes_test {
namespace {

TEST(JobChange, IsReadAsItWasWritten) {
  for (const bool cancel : {false, true}) {
    const JobChange change = {"a job", JobState::kRunning, cancel};
    EXPECT_EQ(JobChangeFromText(ToText(change)), change);
  }
  for (const char* text : {"", " ", "RUNNING", "WALKING a"})
    EXPECT_EQ(JobChangeFromText(text), std::nullopt) << text;
}

TEST(ProgressReport, IsReadAsItWasWritten) {
  for (const ProgressReport& report :
       {ProgressReport{"c1", {}},
        ProgressReport{"c1", {{"a", {7, 1'700'000'000'000'000, 20'000, 12}}, {"b", {1, 2, 3, 4}}}}})
    EXPECT_EQ(ProgressReportFromText(ToText(report)), report);
  for (const char* text : {"", "PROGRESS", "RUNNING a", "PROGRESS c a", "PROGRESS c a 1 2 3 x"})
    EXPECT_EQ(ProgressReportFromText(text), std::nullopt) << text;
}

TEST(ProgressReport, IsNoChangeOfAJob) {
  EXPECT_EQ(JobChangeFromText(ToText(ProgressReport{"c1", {}})), std::nullopt);
}

// PostgreSQL limits the length of a notice.
TEST(ProgressReport, OfManyJobsIsNoLongerThanANotice) {
  ProgressReport report = {std::string(64, 'c'), {}};
  for (int i = 0; i < 200; ++i)
    report.jobs[absl::StrCat(std::string(29, 'a'), 100 + i)] = {123'456, 1'700'000'000'000'000,
                                                                20'000, 20'000};
  EXPECT_LT(ToText(report).size(), 7'999u);
  EXPECT_EQ(ProgressReportFromText(ToText(report))->jobs.size(), kMostReported);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_changes_test
