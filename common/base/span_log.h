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

/// Activity during the work on a job, with its start and its end.
struct Span {
  std::string name;  ///< name of the activity, such as "slicing" or "layers 0-31"
  /// Name of the worker that did the work. Empty: the program that runs the job.
  std::string track = {};
  int64_t begin_us = 0;  ///< start in microseconds since 1970
  int64_t end_us = 0;    ///< end, not before begin_us
  /// Further facts, such as the result of the activity.
  std::map<std::string, std::string> facts = {};

  friend bool operator==(const Span&, const Span&) = default;
};

/// Log of the activities of one job, for people who examine how the job's time was spent. The log
/// never influences the result. The number of spans is limited: beyond the limit, spans are only
/// counted. Thread-safe.
class SpanLog {
 public:
  /// Makes an empty log. `now_us`: current time in microseconds since 1970; the log adds the time
  /// of a monotonic clock to it. `max_spans`: number of spans that are stored; further spans are
  /// only counted.
  SpanLog(int64_t now_us, size_t max_spans) : start_us_(now_us), max_spans_(max_spans) {}

  int64_t NowUs() const { return start_us_ + static_cast<int64_t>(clock_.Seconds() * 1e6); }

  void Add(Span span);

  /// Returns the spans in the order in which they were added.
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

/// Adds a span to a log when this object is destroyed. The span begins with the object's
/// construction. For use by one thread.
class ScopedSpan {
 public:
  /// Begins a span; if `log` is null, nothing is recorded. `name`, `track`: see Span. The log must
  /// outlive this object.
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
