#include "services/coordinator/server/webhooks/webhook_sender.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "services/coordinator/server/webhooks/http_post.h"
#include "services/coordinator/server/webhooks/webhook_message.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::chrono::hours kMaxRetry{2};
constexpr int kMaxDoublings = 16;

int64_t Us(std::chrono::milliseconds time) { return time.count() * 1'000; }

prometheus::Counter& Tries(prometheus::Registry& registry, const char* outcome) {
  return prometheus::BuildCounter()
      .Name("slicefarm_webhook_tries_total")
      .Help("Tries to tell a receiver of a job's end; given_up: the last one of a webhook failed")
      .Register(registry)
      .Add({{"outcome", outcome}});
}

}  // namespace

WebhookSender::WebhookSender(WebhookStore& webhooks, JobStore& jobs, WebhooksNow policy,
                             Options options, std::function<int64_t()> now_us, rpc::JsonLog log,
                             prometheus::Registry& registry)
    : webhooks_(webhooks),
      jobs_(jobs),
      policy_(std::move(policy)),
      options_(options),
      now_us_(std::move(now_us)),
      log_(std::move(log)),
      delivered_(Tries(registry, "delivered")),
      failed_(Tries(registry, "failed")),
      given_up_(Tries(registry, "given_up")) {
  for (int i = 0; i < options_.threads; ++i) threads_.emplace_back([this] { Serve(); });
}

WebhookSender::~WebhookSender() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  stop_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WebhookSender::Serve() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    const bool sent = SendOne();
    lock.lock();
    if (!sent) stop_.wait_for(lock, options_.poll, [this] { return stopping_; });
  }
}

/// Sends one due webhook. Returns false if none is due or if the store failed.
bool WebhookSender::SendOne() {
  const auto due = Claim();
  if (!due.ok()) log_.Warn("outbox not read", {{"error", std::string(due.status().message())}});
  if (!due.ok() || !*due) return false;
  Conclude(**due, Try(**due));
  Count((*due)->tenant, -1);
  return true;
}

absl::StatusOr<std::optional<DueWebhook>> WebhookSender::Claim() {
  // Otherwise, several threads could claim webhooks of the same tenant at once.
  const std::lock_guard lock(claim_mutex_);
  const int64_t now_us = now_us_();
  // The claim outlasts the try, so that no other coordinator sends the webhook meanwhile.
  auto due = webhooks_.Claim(now_us, now_us + 2 * Us(options_.timeout), Busy());
  if (due.ok() && *due) Count((*due)->tenant, 1);
  return due;
}

/// Returns the tenants that use at least half of the threads. With a single thread, there is
/// nothing to share.
std::set<std::string> WebhookSender::Busy() {
  std::lock_guard lock(mutex_);
  std::set<std::string> busy;
  for (const auto& [tenant, tries] : in_flight_)
    if (2 * tries >= options_.threads) busy.insert(tenant);
  return busy;
}

void WebhookSender::Count(const std::string& tenant, int change) {
  std::lock_guard lock(mutex_);
  if ((in_flight_[tenant] += change) == 0) in_flight_.erase(tenant);
}

WebhookAttempt WebhookSender::Try(const DueWebhook& due) {
  const int64_t now_us = now_us_();
  WebhookAttempt attempt = {.attempt = due.attempt, .time_us = now_us};
  const auto job = jobs_.Get(due.job_id);
  if (!job.ok()) {
    attempt.error = std::string(job.status().message());
    return attempt;
  }
  // The list of allowed URLs may have changed since the creation of the job.
  const std::shared_ptr<const WebhookPolicy> policy = policy_();
  if (absl::Status allowed = policy->Check(job->tenant, due.url); !allowed.ok()) {
    attempt.error = std::string(allowed.message());
    return attempt;
  }
  const WebhookRules& rules = *policy->RulesOf(job->tenant);
  const std::string body = WebhookBody(*job);
  const auto status =
      HttpPost(due.url, body,
               {.headers = {fmt::format("Slicefarm-Delivery: {}", due.job_id),
                            fmt::format("Slicefarm-Attempt: {}", due.attempt),
                            fmt::format("Slicefarm-Signature: {}",
                                        WebhookSignature(rules.secrets, now_us / 1'000'000, body))},
                .timeout = options_.timeout,
                .private_addresses = rules.private_addresses});
  if (status.ok()) {
    attempt.http_status = *status;
  } else {
    attempt.error = std::string(status.status().message());
  }
  return attempt;
}

void WebhookSender::Conclude(const DueWebhook& due, const WebhookAttempt& attempt) {
  const bool delivered = attempt.http_status >= 200 && attempt.http_status < 300;
  const bool given_up = !delivered && due.attempt >= options_.max_attempts;
  const int64_t wait_us =
      std::min(Us(kMaxRetry), Us(options_.first_retry) << std::min(due.attempt - 1, kMaxDoublings));
  const WebhookState state = delivered  ? WebhookState::kDelivered
                             : given_up ? WebhookState::kGivenUp
                                        : WebhookState::kDue;
  const absl::Status written = webhooks_.Record(
      due.job_id, attempt, state, state == WebhookState::kDue ? attempt.time_us + wait_us : 0);
  log_.Info(delivered  ? "webhook delivered"
            : given_up ? "webhook given up"
                       : "webhook not delivered",
            {{"job", due.job_id},
             {"attempt", int64_t{due.attempt}},
             {"http_status", int64_t{attempt.http_status}},
             {"error", attempt.error}});
  // If the outcome was not written, the claim expires and the webhook is sent again.
  if (written.ok()) (delivered ? delivered_ : given_up ? given_up_ : failed_).Increment();
  if (!written.ok()) log_.Warn("outbox not written", {{"error", std::string(written.message())}});
}

}  // namespace slicefarm::coordinator
