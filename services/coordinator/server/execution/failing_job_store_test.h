#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/forwarding_job_store.h"

namespace slicefarm::coordinator {

/// Job store for tests. Selected calls fail or block until the test ends the failure.
class FailingJobStore : public ForwardingJobStore {
 public:
  /// Calls that can fail or block.
  enum class Call { kClaim, kRenew, kUpdate, kFindResult };

  using ForwardingJobStore::ForwardingJobStore;

  /// Lets all calls of this kind fail with `error`.
  void Fail(Call call, absl::Status error) {
    const std::lock_guard lock(mutex_);
    errors_[call] = std::move(error);
  }
  /// Lets all calls of this kind wait without an answer.
  void Block(Call call) {
    const std::lock_guard lock(mutex_);
    blocked_.insert(call);
  }
  /// Ends all failures and blocks.
  void Recover() {
    const std::lock_guard lock(mutex_);
    errors_.clear();
    blocked_.clear();
    recovered_.notify_all();
  }
  /// Ends the block of this kind of call.
  void Unblock(Call call) {
    const std::lock_guard lock(mutex_);
    blocked_.erase(call);
    recovered_.notify_all();
  }
  /// Returns the number of calls so far, failed or not.
  int Calls(Call call) {
    const std::lock_guard lock(mutex_);
    return calls_[call];
  }

  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter) override {
    if (absl::Status error = Enter(Call::kClaim); !error.ok()) return error;
    return store().Claim(owner, now_us, until_us, filter);
  }
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override {
    if (absl::Status error = Enter(Call::kRenew); !error.ok()) return error;
    return store().Renew(leases, until_us);
  }
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override {
    if (absl::Status error = Enter(Call::kUpdate); !error.ok()) return error;
    return store().Update(lease, update, now_us);
  }
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& digest) override {
    if (absl::Status error = Enter(Call::kFindResult); !error.ok()) return error;
    return store().FindResult(digest);
  }

 private:
  absl::Status Enter(Call call) {
    std::unique_lock lock(mutex_);
    ++calls_[call];
    recovered_.wait(lock, [&] { return !blocked_.contains(call); });
    const auto error = errors_.find(call);
    return error == errors_.end() ? absl::OkStatus() : error->second;
  }

  std::mutex mutex_;
  std::condition_variable recovered_;
  std::set<Call> blocked_;
  std::map<Call, absl::Status> errors_;
  std::map<Call, int> calls_;
};

}  // namespace slicefarm::coordinator
