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

/// Sizes and digests of texts that are derived from results, so that a large program is read for
/// them once, however many ask. Thread-safe.
class DerivedFacts {
 public:
  struct Fact {
    int64_t size = 0;
    std::string sha256;
  };
  using Make = std::function<absl::StatusOr<std::string>()>;

  /// Returns the fact of the text that `make` gives; `key` names that text. Who asks while another
  /// one makes it waits for him, and makes it himself if that one gives up. Errors: those of
  /// `make`, of which NotFound is kept like a fact; CANCELLED if `cancel` says so meanwhile.
  absl::StatusOr<Fact> Of(const std::string& key, const CancelToken& cancel, const Make& make);

 private:
  static constexpr size_t kMostKept = 4096;

  std::mutex mutex_;
  std::condition_variable made_;
  std::set<std::string> being_made_;
  std::map<std::string, absl::StatusOr<Fact>> kept_;
};

}  // namespace slicefarm::coordinator
