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

/// Sends what is due in the outbox: at least once, again and ever later while the receiver does not
/// answer with 2xx, for about a day. Threads of its own, of which no tenant's receivers take more
/// than half.
class WebhookSender {
 public:
  struct Options {
    int threads = 4;
    std::chrono::milliseconds poll{1'000};
    std::chrono::milliseconds timeout{10'000};      ///< of a try
    std::chrono::milliseconds first_retry{10'000};  ///< twice as long each time, up to two hours
    int max_attempts = 20;
  };

  /// Everything outlives it.
  WebhookSender(WebhookStore& webhooks, JobStore& jobs, WebhooksNow policy, Options options,
                std::function<int64_t()> now_us, rpc::JsonLog log, prometheus::Registry& registry);
  /// Waits for the tries that are on their way.
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
  std::map<std::string, int> in_flight_;  ///< tries, by tenant
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
