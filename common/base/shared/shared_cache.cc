#include "common/base/shared/shared_cache.h"

#include <fmt/core.h>

#include <iterator>

#include "common/base/sha256.h"

namespace slicefarm {

/// Cached value: its bytes until the first request, then the parsed value.
struct SharedCache::Entry {
  explicit Entry(SharedBytes given)
      : kind(std::move(given.kind)),
        digest(std::move(given.digest)),
        size(std::ssize(given.bytes)),
        bytes(std::move(given.bytes)) {}

  const std::string kind;
  const std::string digest;
  const int64_t size;
  std::mutex mutex;  ///< locked while the bytes are parsed
  std::string bytes;
  std::any value;
};

std::string SharedDigest(std::string_view kind, std::string_view bytes) {
  Sha256 sha;
  sha.Add(kind);
  sha.Add(std::string_view("", 1));
  sha.Add(bytes);
  return sha.Hex();
}

std::string MissingDigest(const absl::Status& status) {
  ErrorDetail detail = DetailOf(status);
  return detail.reason == Reason::kSharedMissing ? detail.metadata["digest"] : std::string();
}

bool SharedCache::Has(const std::string& digest) const {
  const std::lock_guard lock(mutex_);
  return by_digest_.contains(digest);
}

void SharedCache::Put(SharedBytes bytes) {
  Entries gone;  // ends outside of the lock: a big value takes time to free
  const std::lock_guard lock(mutex_);
  if (by_digest_.contains(bytes.digest)) return;
  entries_.push_front(std::make_shared<Entry>(std::move(bytes)));
  by_digest_[entries_.front()->digest] = entries_.begin();
  counts_.bytes += entries_.front()->size;
  while (counts_.bytes > capacity_ && entries_.size() > 1) {
    const auto last = std::prev(entries_.end());
    counts_.bytes -= (*last)->size;
    ++counts_.evicted;
    by_digest_.erase((*last)->digest);
    gone.splice(gone.end(), entries_, last);
  }
}

SharedCache::Value SharedCache::TakeAny(const std::string& digest, std::string_view kind,
                                        const std::function<Value(std::string_view)>& read) {
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    const auto found = by_digest_.find(digest);
    if (found == by_digest_.end()) {
      ++counts_.misses;
      return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kSharedMissing,
                       fmt::format("{} with digest {} is not stored here", kind, digest),
                       {{"digest", digest}});
    }
    ++counts_.hits;
    entries_.splice(entries_.begin(), entries_, found->second);
    entry = entries_.front();
  }
  if (entry->kind != kind)
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        fmt::format("the bytes were sent as {} but requested as {}", entry->kind, kind),
        {{"field", "shared"}});
  const std::lock_guard lock(entry->mutex);
  if (!entry->value.has_value()) {
    Value value = read(entry->bytes);
    if (!value.ok()) return value;
    entry->value = *std::move(value);
    std::string().swap(entry->bytes);
  }
  return entry->value;
}

SharedCache::Counts SharedCache::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = counts_;
  counts.entries = std::ssize(entries_);
  return counts;
}

}  // namespace slicefarm
