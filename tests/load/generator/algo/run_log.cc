#include "tests/load/generator/algo/run_log.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::load {
namespace {

/// Returns the text of an error without its message. The message may contain the job's id, which
/// differs each time.
std::string ErrorText(const Outcome& outcome) {
  if (outcome.status.ok()) return "";
  return fmt::format("{}: {} {}", outcome.step, absl::StatusCodeToString(outcome.status.code()),
                     ReasonName(DetailOf(outcome.status).reason));
}

}  // namespace

int64_t RunRecord::succeeded() const {
  const auto ok = codes.find(absl::StatusCode::kOk);
  return ok == codes.end() ? 0 : ok->second;
}

void RunLog::Arrived() {
  const std::lock_guard lock(mutex_);
  ++record_.arrivals;
}

void RunLog::Skipped() {
  const std::lock_guard lock(mutex_);
  ++record_.skipped;
}

void RunLog::Started(int64_t lag_ns) {
  const std::lock_guard lock(mutex_);
  record_.start_lag.Record(lag_ns);
}

void RunLog::Ended(int64_t intended_ns, int64_t end_ns, const Outcome& outcome) {
  Sample sample = {.intended_ns = intended_ns,
                   .latency_ns = end_ns - intended_ns,
                   .code = outcome.status.code(),
                   .error = ErrorText(outcome)};
  const std::lock_guard lock(mutex_);
  record_.latency.Record(sample.latency_ns);
  record_.end_ns = std::max(record_.end_ns, end_ns);
  ++record_.codes[sample.code];
  if (!sample.error.empty()) ++record_.errors[sample.error];
  CountExhausted(outcome);
  if (record_.samples.size() < kMaxSamples) {
    record_.samples.push_back(std::move(sample));
  } else {
    ++record_.samples_left_out;
  }
}

void RunLog::CountExhausted(const Outcome& outcome) {
  if (!absl::IsResourceExhausted(outcome.status)) return;
  ++(outcome.says_when_to_retry ? record_.exhausted_with_retry_info
                                : record_.exhausted_without_retry_info);
}

void RunLog::StepTook(std::string_view step, int64_t ns) {
  const std::lock_guard lock(mutex_);
  record_.steps[std::string(step)].Record(ns);
}

void RunLog::Add(Tally what, int64_t number) {
  const std::lock_guard lock(mutex_);
  record_.tallies[static_cast<size_t>(what)] += number;
}

}  // namespace slicefarm::load
