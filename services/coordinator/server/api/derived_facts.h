#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"

namespace slicefarm::coordinator {

/// Cache of the sizes and digests of texts that are derived from results. With this cache, a large
/// program is read for them only once, for any number of requests. Thread-safe.
class DerivedFacts {
 public:
  /// Size and digest of a text.
  struct Fact {
    int64_t size = 0;
    std::string sha256;
  };
  using Make = std::function<absl::StatusOr<std::string>()>;

  /// Returns the size and digest of the text that `make` returns. `key`: unique name of the text.
  /// If another call is already making the same text, waits for that call; if it fails, calls
  /// `make` itself. Errors: errors of `make`, of which NotFound is cached too; CANCELLED if
  /// `cancel` is cancelled meanwhile.
  absl::StatusOr<Fact> Of(const std::string& key, const CancelToken& cancel, const Make& make);

 private:
  static constexpr size_t kMostKept = 4096;

  std::mutex mutex_;
  std::condition_variable made_;
  std::set<std::string> being_made_;
  std::map<std::string, absl::StatusOr<Fact>> kept_;
};

}  // namespace slicefarm::coordinator
