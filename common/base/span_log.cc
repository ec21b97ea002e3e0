#include "common/base/span_log.h"

namespace slicefarm {

void SpanLog::Add(Span span) {
  const std::lock_guard lock(mutex_);
  if (spans_.size() < max_spans_) {
    spans_.push_back(std::move(span));
  } else {
    ++dropped_;
  }
}

std::vector<Span> SpanLog::spans() const {
  const std::lock_guard lock(mutex_);
  return spans_;
}

int64_t SpanLog::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace slicefarm
