#include "services/coordinator/remote/stage_pool.h"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/health.h"

namespace slicefarm::coordinator {
namespace {

using Clock = std::chrono::steady_clock;

/// Interval at which a waiting call checks for a reachable replica and for its own cancellation.
constexpr std::chrono::milliseconds kPoll{20};
constexpr std::chrono::milliseconds kGreetingPatience{1'000};

bool IsReady(grpc::Channel& channel) {
  return channel.GetState(/*try_to_connect=*/true) == GRPC_CHANNEL_READY;
}

}  // namespace

struct StagePool::Replica {
  Replica(std::string where, const StagePoolOptions& options)
      : address(std::move(where)),
        channel(rpc::MakeChannel(address, {.credentials = options.credentials})) {}

  const std::string address;
  const std::shared_ptr<grpc::Channel> channel;  // gRPC's own handle
  // The pool's mutex protects the following members:
  int in_flight = 0;
  int64_t last_turn = 0;
  Clock::time_point rests_until;
};

/// Call in flight on a replica. Counts the call for the lifetime of this object.
class StagePool::Use {
 public:
  Use(StagePool& pool, Replica& replica) : pool_(pool), replica_(replica) {
    const std::lock_guard lock(pool_.mutex_);
    ++replica_.in_flight;
    replica_.last_turn = ++pool_.turn_;
  }
  ~Use() {
    const std::lock_guard lock(pool_.mutex_);
    --replica_.in_flight;
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  StagePool& pool_;
  Replica& replica_;
};

StagePool::StagePool(std::string stage, std::vector<std::string> names, rpc::JsonLog log,
                     const StagePoolOptions& options)
    : stage_(std::move(stage)),
      names_(names),
      log_(std::move(log)),
      options_(options),
      watch_(
          std::move(names), [this](const auto& addresses) { Update(addresses); }, options.watch) {}

StagePool::~StagePool() = default;

void StagePool::Update(const std::vector<std::string>& addresses) {
  Members updated;
  {
    const std::lock_guard lock(mutex_);
    for (const std::string& address : addresses) {
      const auto known =
          std::ranges::find(replicas_, address, [](const auto& r) { return r->address; });
      updated.push_back(known != replicas_.end() ? *known
                                                 : std::make_shared<Replica>(address, options_));
    }
    replicas_.swap(updated);
    for (const auto& replica : replicas_) replica->channel->GetState(/*try_to_connect=*/true);
    updated_.notify_all();
  }
  log_.Info("replicas", {{"stage", stage_}, {"addresses", absl::StrJoin(addresses, ",")}});
}

absl::Status StagePool::Call(const CancelToken& cancel, const Attempt& attempt) {
  std::set<std::string> tried;
  absl::Status status;
  int lost = 0;
  for (int tries = 0; tries < options_.tries;) {
    const absl::StatusOr<std::shared_ptr<Replica>> replica = AwaitPick(cancel, tried);
    if (!replica.ok()) return replica.status();
    {
      const Use use(*this, **replica);
      status = attempt((*replica)->channel);
    }
    if (IsOverloaded(status)) {
      if (absl::Status wanted = AwaitRetry(status, cancel); !wanted.ok()) return wanted;
      continue;
    }
    if (!IsReplicasFault(status)) return status;
    Failed(**replica, status);
    if (WasLost(status) && ++lost >= options_.lost_tries) return status;
    tried.insert((*replica)->address);
    ++tries;
  }
  return status;
}

void StagePool::Failed(Replica& replica, const absl::Status& status) {
  {
    const std::lock_guard lock(mutex_);
    replica.rests_until = Clock::now() + options_.rest;
  }
  log_.Warn("replica failed", {{"stage", stage_},
                               {"address", replica.address},
                               {"reason", std::string(ReasonName(DetailOf(status).reason))},
                               {"error", std::string(status.message())}});
  watch_.Refresh();
}

/// Returns the best reachable replica; null if there is none. Prefers, in this order: a replica
/// that was not tried; one that has not failed within StagePoolOptions::rest; the fewest calls in
/// flight; the longest idle time.
std::shared_ptr<StagePool::Replica> StagePool::Pick(const std::set<std::string>& tried) {
  const auto now = Clock::now();
  const auto worth = [&](const std::shared_ptr<Replica>& replica) {
    return std::make_tuple(tried.contains(replica->address), replica->rests_until > now,
                           replica->in_flight, replica->last_turn);
  };
  const std::lock_guard lock(mutex_);
  std::shared_ptr<Replica> best;
  for (const auto& replica : replicas_) {
    if (IsReady(*replica->channel) && (best == nullptr || worth(replica) < worth(best)))
      best = replica;
  }
  return best;
}

absl::StatusOr<std::shared_ptr<StagePool::Replica>> StagePool::AwaitPick(
    const CancelToken& cancel, const std::set<std::string>& tried) {
  const auto deadline = Clock::now() + options_.connect_patience;
  for (;;) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    if (std::shared_ptr<Replica> replica = Pick(tried)) return replica;
    if (Clock::now() >= deadline) return NoneReachable();
    watch_.Refresh();
    AwaitChange();
  }
}

/// Waits until there is a replica and its channel changes its state, or for kPoll.
void StagePool::AwaitChange() const {
  std::shared_ptr<grpc::Channel> channel;
  {
    std::unique_lock lock(mutex_);
    if (!updated_.wait_for(lock, kPoll, [this] { return !replicas_.empty(); })) return;
    channel = replicas_.front()->channel;
  }
  channel->WaitForStateChange(channel->GetState(true), std::chrono::system_clock::now() + kPoll);
}

absl::Status StagePool::NoneReachable() const {
  return MakeError(
      absl::StatusCode::kUnavailable, Reason::kUnavailable,
      fmt::format("no {} service can be reached at {}", stage_, absl::StrJoin(names_, ",")),
      {{"stage", stage_}});
}

bool StagePool::AwaitReady(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  while (Pick({}) == nullptr) {
    if (Clock::now() >= deadline) return false;
    AwaitChange();
  }
  return true;
}

bool StagePool::IsAway() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::all_of(replicas_, [](const std::shared_ptr<Replica>& replica) {
    const grpc_connectivity_state state = replica->channel->GetState(/*try_to_connect=*/true);
    return state == GRPC_CHANNEL_TRANSIENT_FAILURE || state == GRPC_CHANNEL_CONNECTING;
  });
}

bool StagePool::OfThisBuild() {
  Members replicas;
  {
    const std::lock_guard lock(mutex_);
    replicas = replicas_;
  }
  bool others = false;
  for (const auto& replica : replicas) {
    if (!IsReady(*replica->channel)) continue;
    const auto fits = rpc::IsServing(replica->channel, rpc::ServiceOfThisBuild(),
                                     {.deadline = kGreetingPatience});
    if (fits.ok() && *fits) return true;
    others = others || fits.ok() || absl::IsNotFound(fits.status());
  }
  return !others;
}

std::vector<std::string> StagePool::Addresses() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> addresses;
  for (const auto& replica : replicas_) addresses.push_back(replica->address);
  return addresses;
}

}  // namespace slicefarm::coordinator
