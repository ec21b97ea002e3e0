#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"
#include "common/base/shared/shared.h"
#include "common/base/shared/shared_bytes.h"

namespace slicefarm {

/// Cache of values that a server has received as bytes; the key is the digest of the bytes. The
/// cache evicts the values that were not added or requested for the longest time. A caller may use
/// a value even after its eviction. Thread-safe.
class SharedCache {
 public:
  struct Counts {
    int64_t hits = 0;     ///< number of requests for values in the cache
    int64_t misses = 0;   ///< number of requests for values not in the cache
    int64_t evicted = 0;  ///< number of evicted values
    int64_t entries = 0;  ///< current number of values
    int64_t bytes = 0;    ///< size of the current values in the form in which they were received
  };

  /// Makes a cache for at most `capacity` bytes. A single larger value is also stored; the cache
  /// then contains no other value.
  explicit SharedCache(int64_t capacity) : capacity_(capacity) {}

  bool Has(const std::string& digest) const;
  /// Adds a value. REQUIRES: the digest is the digest of kind and bytes.
  void Put(SharedBytes bytes);

  /// Returns the value with this digest. The first call converts the bytes by `read(bytes)` and
  /// then discards the bytes. `kind`: kind that the value must have (SharedBytes::kind). Errors:
  /// SHARED_MISSING with metadata `digest`; REQUEST_MALFORMED if the value is of another kind; the
  /// error of `read`.
  template <typename T>
  absl::StatusOr<Shared<T>> Take(const std::string& digest, std::string_view kind,
                                 const std::function<absl::StatusOr<T>(std::string_view)>& read) {
    const auto value = TakeAny(digest, kind, [&](std::string_view bytes) -> Value {
      absl::StatusOr<T> made = read(bytes);
      if (!made.ok()) return made.status();
      return std::any(Shared<T>(*std::move(made)));
    });
    if (!value.ok()) return value.status();
    return *std::any_cast<Shared<T>>(&*value);
  }

  Counts counts() const;

 private:
  using Value = absl::StatusOr<std::any>;
  struct Entry;
  using Entries = std::list<std::shared_ptr<Entry>>;  // shared with those who take from it

  Value TakeAny(const std::string& digest, std::string_view kind,
                const std::function<Value(std::string_view)>& read);

  const int64_t capacity_;
  mutable std::mutex mutex_;
  Entries entries_;  ///< entries, sorted by their last request, the latest first
  std::map<std::string, Entries::iterator, std::less<>> by_digest_;
  Counts counts_;
};

/// Returns the digest that a SHARED_MISSING error contains; an empty text for other errors.
std::string MissingDigest(const absl::Status& status);

}  // namespace slicefarm
