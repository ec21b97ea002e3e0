#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "common/base/stopwatch.h"

namespace slicefarm {

/// A stretch of time in the work on a job.
struct Span {
  std::string name;                               ///< what was done: "slicing", "layers 0-31"
  std::string track = {};                         ///< by whom; empty: by whoever runs the job
  int64_t begin_us = 0;                           ///< since 1970
  int64_t end_us = 0;                             ///< not before begin_us
  std::map<std::string, std::string> facts = {};  ///< such as how it ended

  friend bool operator==(const Span&, const Span&) = default;
};

/// What was done for one job, and when: for people who ask where its time went; never read by what
/// makes the result. Bounded: what does not fit is only counted. Thread-safe.
class SpanLog {
 public:
  /// `now_us`: since 1970; from there on a clock counts that does not run backwards.
  SpanLog(int64_t now_us, size_t max_spans) : start_us_(now_us), max_spans_(max_spans) {}

  int64_t NowUs() const { return start_us_ + static_cast<int64_t>(clock_.Seconds() * 1e6); }

  void Add(Span span);

  /// In the order of their adding.
  std::vector<Span> spans() const;
  int64_t dropped() const;

 private:
  const int64_t start_us_;
  const size_t max_spans_;
  const Stopwatch clock_;
  mutable std::mutex mutex_;
  std::vector<Span> spans_;
  int64_t dropped_ = 0;
};

/// A span as long as it is in scope. For one thread.
class ScopedSpan {
 public:
  /// Without a log, nothing is kept. The log must outlive it.
  ScopedSpan(SpanLog* log, std::string name, std::string track = "") : log_(log) {
    if (log_ != nullptr) span_ = {std::move(name), std::move(track), log_->NowUs()};
  }
  ~ScopedSpan() {
    if (log_ == nullptr) return;
    span_.end_us = log_->NowUs();
    log_->Add(std::move(span_));
  }
  ScopedSpan(const ScopedSpan&) = delete;
  ScopedSpan& operator=(const ScopedSpan&) = delete;

  void Set(const std::string& fact, std::string value) {
    if (log_ != nullptr) span_.facts[fact] = std::move(value);
  }

 private:
  SpanLog* const log_;
  Span span_;
};

}  // namespace slicefarm
