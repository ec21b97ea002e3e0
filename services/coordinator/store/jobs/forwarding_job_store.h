#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// JobStore that passes every call to one function of `Derived`, which derives from this class:
///
///   template <typename Method, typename... Args>
///   auto Dispatch(const char* name, Method method, const Args&... args);
///
/// `method` is the called method of JobStore, and `args` are its arguments.
template <typename Derived>
class JobStoreCalls : public JobStore {
 public:
  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override {
    return Make("Create", &JobStore::Create, job, now_us);
  }
  absl::StatusOr<std::vector<Created>> CreateAll(const std::vector<NewJob>& jobs,
                                                 int64_t now_us) override {
    return Make("CreateAll", &JobStore::CreateAll, jobs, now_us);
  }
  absl::StatusOr<JobRecord> Get(const std::string& id) override {
    return Make("Get", &JobStore::Get, id);
  }
  absl::StatusOr<std::string> TenantOf(const std::string& id) override {
    return Make("TenantOf", &JobStore::TenantOf, id);
  }
  absl::StatusOr<std::vector<JobRecord>> List(const ListQuery& query) override {
    return Make("List", &JobStore::List, query);
  }
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter = {}) override {
    return Make("Claim", &JobStore::Claim, owner, now_us, until_us, filter);
  }
  absl::StatusOr<std::vector<JobRecord>> EndOverdue(const JobError& error, int64_t now_us,
                                                    int32_t limit) override {
    return Make("EndOverdue", &JobStore::EndOverdue, error, now_us, limit);
  }
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override {
    return Make("Adopt", &JobStore::Adopt, lease, identity, now_us);
  }
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override {
    return Make("Renew", &JobStore::Renew, leases, until_us);
  }
  absl::Status Release(const std::string& owner) override {
    return Make("Release", &JobStore::Release, owner);
  }
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override {
    return Make("Update", &JobStore::Update, lease, update, now_us);
  }
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override {
    return Make("RequestCancel", &JobStore::RequestCancel, id, now_us);
  }
  absl::StatusOr<JobRecord> Change(const std::string& id, const JobChanging& changing,
                                   int64_t now_us) override {
    return Make("Change", &JobStore::Change, id, changing, now_us);
  }
  absl::Status Delete(const std::string& id) override {
    return Make("Delete", &JobStore::Delete, id);
  }
  absl::StatusOr<std::vector<JobRecord>> FindRequested(const std::string& tenant,
                                                       const std::vector<std::string>& request_ids,
                                                       const std::string& spec_digest) override {
    return Make("FindRequested", &JobStore::FindRequested, tenant, request_ids, spec_digest);
  }
  absl::StatusOr<JobRecord> GetWithoutSpec(const std::string& id) override {
    return Make("GetWithoutSpec", &JobStore::GetWithoutSpec, id);
  }
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override {
    return Make("Events", &JobStore::Events, id, after, limit);
  }
  absl::StatusOr<std::vector<TenantEvent>> EventsOf(const std::string& tenant,
                                                    const EventCursor& after,
                                                    int32_t limit) override {
    return Make("EventsOf", &JobStore::EventsOf, tenant, after, limit);
  }
  absl::StatusOr<std::optional<JobResult>> FindResult(const std::string& action_digest) override {
    return Make("FindResult", &JobStore::FindResult, action_digest);
  }
  absl::Status ForgetResult(const std::string& action_digest) override {
    return Make("ForgetResult", &JobStore::ForgetResult, action_digest);
  }
  absl::Status ExpireRequestIds(int64_t now_us) override {
    return Make("ExpireRequestIds", &JobStore::ExpireRequestIds, now_us);
  }
  absl::StatusOr<std::map<JobState, int64_t>> CountEnded() override {
    return Make("CountEnded", &JobStore::CountEnded);
  }
  absl::StatusOr<int64_t> CountOf(const std::string& tenant) override {
    return Make("CountOf", &JobStore::CountOf, tenant);
  }
  absl::StatusOr<std::map<JobState, int64_t>> CountOpenOf(const std::string& tenant) override {
    return Make("CountOpenOf", &JobStore::CountOpenOf, tenant);
  }
  absl::StatusOr<std::vector<OpenJobs>> CountOpen() override {
    return Make("CountOpen", &JobStore::CountOpen);
  }
  absl::StatusOr<QueueSnapshot> ReadQueue(int64_t now_us) override {
    return Make("ReadQueue", &JobStore::ReadQueue, now_us);
  }
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override {
    return Make("Referenced", &JobStore::Referenced, tenant, digests);
  }
  absl::StatusOr<std::set<std::string>> Artifacts(const std::string& tenant,
                                                  const std::set<std::string>& digests) override {
    return Make("Artifacts", &JobStore::Artifacts, tenant, digests);
  }
  absl::StatusOr<std::vector<std::string>> EndedBefore(int64_t time_us, int32_t limit) override {
    return Make("EndedBefore", &JobStore::EndedBefore, time_us, limit);
  }
  absl::StatusOr<int64_t> InUseSince(int64_t now_us, int64_t most_gap_us) override {
    return Make("InUseSince", &JobStore::InUseSince, now_us, most_gap_us);
  }
  absl::StatusOr<bool> TakeChore(const std::string& chore, int64_t now_us,
                                 int64_t until_us) override {
    return Make("TakeChore", &JobStore::TakeChore, chore, now_us, until_us);
  }

 private:
  template <typename Method, typename... Args>
  auto Make(const char* name, Method method, const Args&... args) {
    return static_cast<Derived&>(*this).Dispatch(name, method, args...);
  }
};

/// JobStore that passes each call to another store. Base class of stores that override some of the
/// calls.
class ForwardingJobStore : public JobStoreCalls<ForwardingJobStore> {
 public:
  /// Passes the calls to `store`, which must outlive this object.
  explicit ForwardingJobStore(JobStore& store) : store_(store) {}

  template <typename Method, typename... Args>
  /// Calls the method of the other store.
  auto Dispatch(const char* /*name*/, Method method, const Args&... args) {
    return (store_.*method)(args...);
  }

 protected:
  JobStore& store() { return store_; }

 private:
  JobStore& store_;
};

}  // namespace slicefarm::coordinator
