#pragma once

#include <prometheus/counter.h>
#include <prometheus/registry.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/server/webhooks/webhook_policy.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"

namespace slicefarm::coordinator {

/// Sends the due webhooks of the outbox (WebhookStore), each at least once. If the receiver does
/// not answer with 2xx, the sender retries for about a day, with increasing pauses. It has threads
/// of its own, of which the receivers of one tenant use at most half.
class WebhookSender {
 public:
  /// Options of a WebhookSender.
  struct Options {
    int threads = 4;
    std::chrono::milliseconds poll{1'000};
    std::chrono::milliseconds timeout{10'000};  ///< time limit of a try
    /// First pause; each further pause is twice as long, up to two hours.
    std::chrono::milliseconds first_retry{10'000};
    int max_attempts = 20;
  };

  /// Starts the threads. All arguments must outlive the sender.
  WebhookSender(WebhookStore& webhooks, JobStore& jobs, WebhooksNow policy, Options options,
                std::function<int64_t()> now_us, rpc::JsonLog log, prometheus::Registry& registry);
  /// Waits for the tries in progress.
  ~WebhookSender();

 private:
  void Serve();
  bool SendOne();
  absl::StatusOr<std::optional<DueWebhook>> Claim();
  std::set<std::string> Busy();
  void Count(const std::string& tenant, int change);
  WebhookAttempt Try(const DueWebhook& due);
  void Conclude(const DueWebhook& due, const WebhookAttempt& attempt);

  WebhookStore& webhooks_;
  JobStore& jobs_;
  const WebhooksNow policy_;
  const Options options_;
  const std::function<int64_t()> now_us_;
  const rpc::JsonLog log_;
  prometheus::Counter& delivered_;
  prometheus::Counter& failed_;
  prometheus::Counter& given_up_;
  std::mutex claim_mutex_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopping_ = false;
  std::map<std::string, int> in_flight_;  ///< number of tries in progress, by tenant
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
