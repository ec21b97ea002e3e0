#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Webhook that is due and was claimed for one delivery attempt.
struct DueWebhook {
  std::string job_id;
  std::string tenant;
  std::string url;
  int32_t attempt = 1;  ///< number of the attempt, counted from 1
};

/// Result of one delivery attempt.
struct WebhookAttempt {
  int32_t attempt = 1;
  int64_t time_us = 0;
  int32_t http_status = 0;  ///< status of the receiver's answer; 0: no answer
  std::string error = {};   ///< reason why no answer arrived; empty: an answer arrived

  friend bool operator==(const WebhookAttempt&, const WebhookAttempt&) = default;
};

/// State of a webhook.
enum class WebhookState {
  kWaiting,    ///< the job has not ended
  kDue,        ///< the next attempt is due or planned
  kDelivered,  ///< the receiver answered with 2xx
  kGivenUp,
};

/// Webhook of a job, and the results of its attempts.
struct WebhookRecord {
  std::string url;
  WebhookState state = WebhookState::kWaiting;
  int64_t due_us = 0;  ///< time of the next attempt, in the state kDue
  std::vector<WebhookAttempt> attempts = {};

  friend bool operator==(const WebhookRecord&, const WebhookRecord&) = default;
};

/// Outbox of webhooks. JobStore::Create writes a webhook together with its job, and the transaction
/// that ends the job makes the webhook due. So no webhook is lost, but one may be sent twice. A
/// webhook is deleted together with its job. Thread-safe; several coordinators may share one store.
/// Errors of all functions: STORE_FAILED; DISK_FULL.
class WebhookStore {
 public:
  virtual ~WebhookStore() = default;

  /// Claims the webhook that has been due for longest, except webhooks of the tenants `busy`. No
  /// other coordinator gets it before `until_us`. Returns nullopt if none is due.
  virtual absl::StatusOr<std::optional<DueWebhook>> Claim(
      int64_t now_us, int64_t until_us, const std::set<std::string>& busy = {}) = 0;

  /// Records the result of an attempt, and the new state. `again_us`: time of the next attempt, in
  /// the state kDue. If another coordinator has claimed the webhook since, because this claim has
  /// expired, only adds the attempt to the log.
  virtual absl::Status Record(const std::string& job_id, const WebhookAttempt& attempt,
                              WebhookState state, int64_t again_us) = 0;

  /// Returns the webhook of a job; nullopt if it has none.
  virtual absl::StatusOr<std::optional<WebhookRecord>> Get(const std::string& job_id) = 0;
};

}  // namespace slicefarm::coordinator
