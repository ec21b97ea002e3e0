#include "tests/load/generator/algo/report_json.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <thread>

#include "absl/time/time.h"

namespace slicefarm::load {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kGhzPercentages = {10, 25, 50, 75, 90, 95, 99};
constexpr std::array kPercentiles = {50.0, 90.0, 95.0, 99.0, 99.9, 99.99};
constexpr int kHistogramSteps = 10;

std::string Time(int64_t us_since_1970) {
  return absl::FormatTime(absl::RFC3339_full, absl::FromUnixMicros(us_since_1970),
                          absl::UTCTimeZone());
}

Json Percentiles(const LatencyHistogram& latency) {
  Json percentiles = {{"count", latency.count()}};
  for (const double percent : kPercentiles) {
    percentiles[fmt::format("p{}", percent)] = latency.PercentileNs(percent);
  }
  percentiles["max"] = latency.max_ns();
  return percentiles;
}

/// The percentages of ghz are integers, and readers in Go accept no other numbers.
Json LatencyDistribution(const LatencyHistogram& latency) {
  Json list = Json::array();
  if (latency.count() == 0) return list;
  for (const int percentage : kGhzPercentages) {
    list.push_back({{"percentage", percentage}, {"latency", latency.PercentileNs(percentage)}});
  }
  return list;
}

/// The marks are at equal distances from the fastest to the slowest request, as in ghz.
Json Histogram(const LatencyHistogram& latency) {
  Json list = Json::array();
  if (latency.count() == 0) return list;
  int64_t before = 0;
  for (int i = 0; i <= kHistogramSteps; ++i) {
    const int64_t mark =
        latency.min_ns() + (latency.max_ns() - latency.min_ns()) / kHistogramSteps * i;
    const int64_t up_to = i == kHistogramSteps ? latency.count() : latency.CountUpTo(mark);
    const int64_t count = up_to - before;
    list.push_back(
        {{"mark", static_cast<double>(mark) / 1e9},
         {"count", count},
         {"frequency", static_cast<double>(count) / static_cast<double>(latency.count())}});
    before = up_to;
  }
  return list;
}

Json Details(const RunReport& run) {
  Json list = Json::array();
  for (const Sample& sample : run.record.samples) {
    list.push_back({{"timestamp", Time(run.begin_us + sample.intended_ns / 1000)},
                    {"latency", sample.latency_ns},
                    {"error", sample.error},
                    {"status", GoCodeName(sample.code)}});
  }
  return list;
}

Json Options(const RunReport& run) {
  return {{"host", run.server},
          {"call", run.scenario},
          {"insecure", true},
          {"concurrency", run.in_flight},
          {"connections", run.connections},
          {"duration", static_cast<int64_t>(run.seconds * 1e9)},
          {"timeout", static_cast<int64_t>(run.deadline_s * 1e9)},
          {"binary", false},
          {"CPUs", std::thread::hardware_concurrency()}};
}

Json StatusCodes(const RunRecord& record) {
  Json codes = Json::object();
  for (const auto& [code, count] : record.codes) codes[std::string(GoCodeName(code))] = count;
  return codes;
}

Json Steps(const RunRecord& record) {
  Json steps = Json::object();
  for (const auto& [step, latency] : record.steps) steps[step] = Percentiles(latency);
  return steps;
}

/// Returns the part of the report that ghz also has.
Json GhzReport(const RunReport& run) {
  const RunRecord& record = run.record;
  const double total_s = run.TotalSeconds();
  return {{"name", "slicefarm-load " + run.scenario},
          {"endReason", "normal"},
          {"options", Options(run)},
          {"date", Time(run.begin_us)},
          {"count", record.latency.count()},
          {"total", static_cast<int64_t>(total_s * 1e9)},
          {"average", static_cast<int64_t>(record.latency.mean_ns())},
          {"fastest", record.latency.min_ns()},
          {"slowest", record.latency.max_ns()},
          {"rps", static_cast<double>(record.latency.count()) / total_s},
          {"errorDistribution", record.errors},
          {"statusCodeDistribution", StatusCodes(record)},
          {"latencyDistribution", LatencyDistribution(record.latency)},
          {"histogram", Histogram(record.latency)}};
}

Json ToJson(const RunReport& run) {
  const RunRecord& record = run.record;
  Json json = GhzReport(run);
  json["mode"] = run.open_loop() ? "open" : "closed";
  json["scenario"] = run.scenario;
  json["mix"] = run.mix;
  json["process"] = run.process;
  json["same"] = run.same;
  json["retry"] = run.retry;
  json["seed"] = run.seed;
  json["build_id"] = run.build_id;
  json["intended_rps"] = run.open_loop() ? Json(run.intended_rps) : Json();
  json["achieved_rps"] = run.AchievedRps();
  json["arrivals"] = record.arrivals;
  json["skipped"] = record.skipped;
  json["succeeded"] = record.succeeded();
  json["resource_exhausted"] = {{"with_retry_info", record.exhausted_with_retry_info},
                                {"without_retry_info", record.exhausted_without_retry_info}};
  json["retries"] = record.tally(Tally::kRetries);
  json["events"] = record.tally(Tally::kEvents);
  json["cached_jobs"] = record.tally(Tally::kCachedJobs);
  json["bytes_sent"] = record.tally(Tally::kBytesSent);
  json["bytes_received"] = record.tally(Tally::kBytesReceived);
  json["percentiles"] = Percentiles(record.latency);
  json["start_lag"] = Percentiles(record.start_lag);
  json["steps"] = Steps(record);
  json["cpu_s"] = run.cpu_s;
  json["rss"] = run.rss_bytes;
  json["details_left_out"] = record.samples_left_out;
  json["details"] = Details(run);
  return json;
}

}  // namespace

std::string_view GoCodeName(absl::StatusCode code) {
  constexpr std::array<std::string_view, 17> kNames = {
      "OK",       "Canceled",       "Unknown",          "InvalidArgument",   "DeadlineExceeded",
      "NotFound", "AlreadyExists",  "PermissionDenied", "ResourceExhausted", "FailedPrecondition",
      "Aborted",  "OutOfRange",     "Unimplemented",    "Internal",          "Unavailable",
      "DataLoss", "Unauthenticated"};
  const auto index = static_cast<size_t>(code);
  return index < kNames.size() ? kNames[index] : "Unknown";
}

std::string ReportJson(const std::vector<RunReport>& runs) {
  if (runs.size() == 1) return ToJson(runs.front()).dump(1) + "\n";
  Json list = Json::array();
  for (const RunReport& run : runs) list.push_back(ToJson(run));
  return list.dump(1) + "\n";
}

}  // namespace slicefarm::load
