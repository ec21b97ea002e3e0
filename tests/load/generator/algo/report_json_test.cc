#include "tests/load/generator/algo/report_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::load::report_json_test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;

constexpr int64_t kMs = 1'000'000;

/// Returns a report of 100 requests of 1 to 100 ms. Every tenth failed, and 3 more were skipped.
RunReport Sample() {
  RunLog log;
  for (int i = 1; i <= 103; ++i) log.Arrived();
  for (int i = 0; i < 3; ++i) log.Skipped();
  for (int i = 1; i <= 100; ++i) {
    Outcome outcome;
    if (i % 10 == 0) outcome = {.status = absl::UnavailableError("gone"), .step = "CreateJob"};
    log.Started(i);
    log.Ended(i * kMs, 2 * i * kMs, outcome);
  }
  log.StepTook("CreateJob", 5 * kMs);
  RunReport report;
  report.scenario = "submit";
  report.server = "127.0.0.1:1";
  report.mix = "tiny";
  report.process = "laser";
  report.intended_rps = 10;
  report.seconds = 10;
  report.deadline_s = 2;
  report.begin_us = 1'500'000;
  report.cpu_s = 1.5;
  report.rss_bytes = 4096;
  report.record = log.Take();
  return report;
}

TEST(ReportJson, HasWhatGhzHas) {
  const Json json = Json::parse(ReportJson({Sample()}));
  EXPECT_EQ(json["count"], 100);
  EXPECT_EQ(json["total"], 10'000 * kMs);
  EXPECT_EQ(json["average"], 50'500'000);
  EXPECT_EQ(json["fastest"], 1 * kMs);
  EXPECT_EQ(json["slowest"], 100 * kMs);
  EXPECT_EQ(json["rps"], 10.0);
  EXPECT_EQ(json["endReason"], "normal");
  EXPECT_EQ(json["date"], "1970-01-01T00:00:01.5+00:00");
  EXPECT_EQ(json["options"]["timeout"], 2'000 * kMs);
  EXPECT_EQ(json["statusCodeDistribution"], Json({{"OK", 90}, {"Unavailable", 10}}));
  EXPECT_EQ(json["errorDistribution"], Json({{"CreateJob: UNAVAILABLE UNAVAILABLE", 10}}));
}

TEST(ReportJson, PercentagesAreWholeAndOverFailedRequestsToo) {
  const Json list = Json::parse(ReportJson({Sample()}))["latencyDistribution"];
  std::vector<int> percentages;
  for (const Json& entry : list) {
    ASSERT_TRUE(entry["percentage"].is_number_integer());
    const int percentage = entry["percentage"];
    percentages.push_back(percentage);
    // The i-th of 100 requests took i ms.
    EXPECT_NEAR(entry["latency"].get<double>(), percentage * kMs, percentage * kMs * 0.01);
  }
  EXPECT_THAT(percentages, ElementsAre(10, 25, 50, 75, 90, 95, 99));
}

TEST(ReportJson, HistogramHoldsAllRequests) {
  const Json list = Json::parse(ReportJson({Sample()}))["histogram"];
  ASSERT_EQ(list.size(), 11u);
  EXPECT_DOUBLE_EQ(list.front()["mark"], 0.001);
  EXPECT_DOUBLE_EQ(list.back()["mark"], 0.1);
  int count = 0;
  double frequency = 0;
  for (const Json& bucket : list) {
    count += bucket["count"].get<int>();
    frequency += bucket["frequency"].get<double>();
  }
  EXPECT_EQ(count, 100);
  EXPECT_NEAR(frequency, 1, 1e-9);
}

TEST(ReportJson, DetailsAreStampedWithTheIntendedStart) {
  const Json list = Json::parse(ReportJson({Sample()}))["details"];
  ASSERT_EQ(list.size(), 100u);
  EXPECT_EQ(list[9], Json({{"timestamp", "1970-01-01T00:00:01.51+00:00"},
                           {"latency", 10 * kMs},
                           {"error", "CreateJob: UNAVAILABLE UNAVAILABLE"},
                           {"status", "Unavailable"}}));
  EXPECT_EQ(list[0]["error"], "");
  EXPECT_EQ(list[0]["status"], "OK");
}

TEST(ReportJson, HasWhatGhzHasNot) {
  const Json json = Json::parse(ReportJson({Sample()}));
  EXPECT_EQ(json["mode"], "open");
  EXPECT_EQ(json["intended_rps"], 10.0);
  EXPECT_EQ(json["achieved_rps"], 9.0);
  EXPECT_EQ(json["arrivals"], 103);
  EXPECT_EQ(json["skipped"], 3);
  EXPECT_EQ(json["cpu_s"], 1.5);
  EXPECT_EQ(json["rss"], 4096);
  for (const char* percentile : {"p50", "p90", "p95", "p99", "p99.9", "p99.99", "max"}) {
    EXPECT_TRUE(json["percentiles"].contains(percentile)) << percentile;
  }
  EXPECT_EQ(json["percentiles"]["max"], 100 * kMs);
  EXPECT_EQ(json["steps"]["CreateJob"]["max"], 5 * kMs);
  for (const char* key :
       {"seed", "scenario", "mix", "process", "same", "retry", "resource_exhausted", "retries",
        "events", "cached_jobs", "start_lag", "details_left_out"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST(ReportJson, AClosedLoopIntendsNoRate) {
  RunReport report = Sample();
  report.intended_rps = 0;
  const Json json = Json::parse(ReportJson({report}));
  EXPECT_EQ(json["mode"], "closed");
  EXPECT_TRUE(json["intended_rps"].is_null());
}

TEST(ReportJson, SeveralRunsAreAnArray) {
  const Json json = Json::parse(ReportJson({Sample(), Sample()}));
  ASSERT_TRUE(json.is_array());
  EXPECT_EQ(json.size(), 2u);
  EXPECT_EQ(json[1]["count"], 100);
}

TEST(ReportJson, NothingHappened) {
  RunReport report;
  report.seconds = 1;
  const Json json = Json::parse(ReportJson({report}));
  EXPECT_EQ(json["count"], 0);
  EXPECT_EQ(json["histogram"], Json::array());
  EXPECT_EQ(json["latencyDistribution"], Json::array());
}

TEST(GoCodeName, AreThoseOfGo) {
  EXPECT_EQ(GoCodeName(absl::StatusCode::kOk), "OK");
  EXPECT_EQ(GoCodeName(absl::StatusCode::kCancelled), "Canceled");
  EXPECT_EQ(GoCodeName(absl::StatusCode::kDeadlineExceeded), "DeadlineExceeded");
  EXPECT_EQ(GoCodeName(absl::StatusCode::kUnauthenticated), "Unauthenticated");
  EXPECT_EQ(GoCodeName(static_cast<absl::StatusCode>(99)), "Unknown");
}

}  // namespace
}  // namespace slicefarm::load::report_json_test
