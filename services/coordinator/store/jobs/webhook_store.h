#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// A delivery that somebody has to try now.
struct DueWebhook {
  std::string job_id;
  std::string tenant;
  std::string url;
  int32_t attempt = 1;  ///< counts from 1
};

/// What a try came to.
struct WebhookAttempt {
  int32_t attempt = 1;
  int64_t time_us = 0;
  int32_t http_status = 0;  ///< 0: no answer
  std::string error = {};   ///< empty: none

  friend bool operator==(const WebhookAttempt&, const WebhookAttempt&) = default;
};

enum class WebhookState {
  kWaiting,    ///< the job has not ended
  kDue,        ///< to be tried, for the first time or again
  kDelivered,  ///< the receiver answered 2xx
  kGivenUp,
};

/// The webhook of a job, and what became of it.
struct WebhookRecord {
  std::string url;
  WebhookState state = WebhookState::kWaiting;
  int64_t due_us = 0;  ///< of kDue
  std::vector<WebhookAttempt> attempts = {};

  friend bool operator==(const WebhookRecord&, const WebhookRecord&) = default;
};

/// The outbox: JobStore::Create writes a webhook with its job, and makes it due in the transaction
/// that ends the job; so none is forgotten, and one may be sent twice. It goes with its job.
/// Thread-safe; several coordinators may share one store. Errors of all: STORE_FAILED; DISK_FULL.
class WebhookStore {
 public:
  virtual ~WebhookStore() = default;

  /// The one that has been due for longest, but for those of `busy` tenants; nobody else gets it
  /// before `until_us`. nullopt: none is due.
  virtual absl::StatusOr<std::optional<DueWebhook>> Claim(
      int64_t now_us, int64_t until_us, const std::set<std::string>& busy = {}) = 0;

  /// Writes what a claimed one came to. `again_us`: when it is due again, with kDue. A claim that
  /// ran out and was taken by another leaves its line in the log only.
  virtual absl::Status Record(const std::string& job_id, const WebhookAttempt& attempt,
                              WebhookState state, int64_t again_us) = 0;

  /// nullopt: the job has none.
  virtual absl::StatusOr<std::optional<WebhookRecord>> Get(const std::string& job_id) = 0;
};

}  // namespace slicefarm::coordinator
