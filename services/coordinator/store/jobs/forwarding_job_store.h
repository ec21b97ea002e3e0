#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// A JobStore that hands each call on to another one: for those that change some of them.
class ForwardingJobStore : public JobStore {
 public:
  /// `store` outlives this.
  explicit ForwardingJobStore(JobStore& store) : store_(store) {}

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override {
    return store_.Create(job, now_us);
  }
  absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                 int64_t now_us) override {
    return store_.CreateAll(jobs, now_us);
  }
  absl::StatusOr<JobRecord> Get(const std::string& id) override { return store_.Get(id); }
  absl::StatusOr<std::string> TenantOf(const std::string& id) override {
    return store_.TenantOf(id);
  }
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override {
    return store_.List(query);
  }
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter = {}) override {
    return store_.Claim(owner, now_us, until_us, filter);
  }
  absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                    int32_t limit) override {
    return store_.EndOverdue(error, now_us, limit);
  }
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override {
    return store_.Adopt(lease, identity, now_us);
  }
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override {
    return store_.Renew(leases, until_us);
  }
  absl::Status Release(const std::string& owner) override { return store_.Release(owner); }
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override {
    return store_.Update(lease, update, now_us);
  }
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override {
    return store_.RequestCancel(id, now_us);
  }
  absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                   int64_t now_us) override {
    return store_.Change(id, changing, now_us);
  }
  absl::Status Delete(const std::string& id) override { return store_.Delete(id); }
  absl::StatusOr<std::vector<JobRecord>> FindRequested(const std::string& tenant,
                                                       const std::vector<std::string>& request_ids,
                                                       const std::string& spec_digest) override {
    return store_.FindRequested(tenant, request_ids, spec_digest);
  }
  absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) override {
    return store_.GetWithoutSpec(id);
  }
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override {
    return store_.Events(id, after, limit);
  }
  absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                    const EventPlace& after,
                                                    int32_t limit) override {
    return store_.EventsOf(tenant, after, limit);
  }
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) override {
    return store_.FindResult(action_digest);
  }
  absl::Status ForgetResult(const std::string& action_digest) override {
    return store_.ForgetResult(action_digest);
  }
  absl::Status ExpireRequestIds(int64_t now_us) override { return store_.ExpireRequestIds(now_us); }
  absl::StatusOr<std::map<JobState, int64_t>> CountEnded() override { return store_.CountEnded(); }
  absl::StatusOr<int64_t> CountOf(const std::string& tenant) override {
    return store_.CountOf(tenant);
  }
  absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) override {
    return store_.CountOpenOf(tenant);
  }
  absl::StatusOr<std::vector<OpenJobs>> CountOpen() override { return store_.CountOpen(); }
  absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) override {
    return store_.ReadQueue(now_us);
  }
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override {
    return store_.Referenced(tenant, digests);
  }
  absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                  const std::set<std::string>& digests) override {
    return store_.Artifacts(tenant, digests);
  }
  absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) override {
    return store_.EndedBefore(time_us, limit);
  }
  absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) override {
    return store_.InUseSince(now_us, most_gap_us);
  }
  absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                 int64_t until_us) override {
    return store_.TakeChore(chore, now_us, until_us);
  }

 protected:
  JobStore& store() { return store_; }

 private:
  JobStore& store_;
};

}  // namespace slicefarm::coordinator
