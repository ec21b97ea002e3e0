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

/// Values that came as bytes, by their digest: the newest, and those asked for last, as many as
/// fit. A value that was taken lives on with who took it, whatever becomes of it here. Thread-safe.
class SharedCache {
 public:
  struct Counts {
    int64_t hits = 0;     ///< that were asked for and there
    int64_t misses = 0;   ///< that were asked for and not there
    int64_t evicted = 0;  ///< that had to go
    int64_t entries = 0;  ///< at the moment
    int64_t bytes = 0;    ///< of these, as they came
  };

  /// Keeps at most `capacity` bytes, or one value that is longer.
  explicit SharedCache(int64_t capacity) : capacity_(capacity) {}

  bool Has(const std::string& digest) const;
  /// REQUIRES: the digest is that of kind and bytes.
  void Put(SharedBytes bytes);

  /// The value of a digest, of that kind: `read(bytes)` makes it at the first call, and the bytes
  /// go. Errors: SHARED_MISSING with metadata `digest`; REQUEST_MALFORMED if it is of another kind;
  /// those of `read`.
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
  Entries entries_;  ///< the one asked for last comes first
  std::map<std::string, Entries::iterator, std::less<>> by_digest_;
  Counts counts_;
};

/// The digest that SHARED_MISSING names; empty for other errors.
std::string MissingDigest(const absl::Status& status);

}  // namespace slicefarm
