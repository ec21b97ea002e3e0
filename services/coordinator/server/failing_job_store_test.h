#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/job_store.h"

namespace slicefarm::coordinator {

/// For tests: a store some of whose calls fail, for as long as they are told to.
class FailingJobStore : public JobStore {
 public:
  enum class Call { kClaim, kRenew, kUpdate, kFindResult };

  explicit FailingJobStore(JobStore& store) : store_(store) {}

  void Fail(Call call, absl::Status error) {
    const std::lock_guard lock(mutex_);
    errors_[call] = std::move(error);
  }
  void Recover() {
    const std::lock_guard lock(mutex_);
    errors_.clear();
  }
  /// Calls so far, failed or not.
  int Calls(Call call) {
    const std::lock_guard lock(mutex_);
    return calls_[call];
  }

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override {
    return store_.Create(job, now_us);
  }
  absl::StatusOr<JobRecord> Get(const std::string& id) override { return store_.Get(id); }
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override {
    return store_.List(query);
  }
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const std::set<std::string>& busy) override {
    if (absl::Status error = Enter(Call::kClaim); !error.ok()) return error;
    return store_.Claim(owner, now_us, until_us, busy);
  }
  absl::Status Adopt(const Lease& lease, const JobIdentity& identity) override {
    return store_.Adopt(lease, identity);
  }
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override {
    if (absl::Status error = Enter(Call::kRenew); !error.ok()) return error;
    return store_.Renew(leases, until_us);
  }
  absl::Status Release(const std::string& owner) override { return store_.Release(owner); }
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override {
    if (absl::Status error = Enter(Call::kUpdate); !error.ok()) return error;
    return store_.Update(lease, update, now_us);
  }
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override {
    return store_.RequestCancel(id, now_us);
  }
  absl::Status Delete(const std::string& id) override { return store_.Delete(id); }
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override {
    return store_.Events(id, after, limit);
  }
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& digest) override {
    if (absl::Status error = Enter(Call::kFindResult); !error.ok()) return error;
    return store_.FindResult(digest);
  }
  absl::Status ForgetResult(const std::string& digest) override {
    return store_.ForgetResult(digest);
  }
  absl::Status ExpireRequestIds(int64_t now_us) override { return store_.ExpireRequestIds(now_us); }
  absl::StatusOr<std::map<JobState, int64_t>> CountByState() override {
    return store_.CountByState();
  }
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override {
    return store_.Referenced(tenant, digests);
  }
  absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) override {
    return store_.EndedBefore(time_us, limit);
  }

 private:
  absl::Status Enter(Call call) {
    const std::lock_guard lock(mutex_);
    ++calls_[call];
    const auto error = errors_.find(call);
    return error == errors_.end() ? absl::OkStatus() : error->second;
  }

  JobStore& store_;
  std::mutex mutex_;
  std::map<Call, absl::Status> errors_;
  std::map<Call, int> calls_;
};

}  // namespace slicefarm::coordinator
