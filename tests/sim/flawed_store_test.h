#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/forwarding_job_store.h"

namespace slicefarm::coordinator::sim {

/// Job store for tests that breaks the contract with one flaw.
class FlawedStore : public ForwardingJobStore {
 public:
  /// Flaws of a store.
  enum class Flaw {
    kNoFencing,            ///< a coordinator that lost a job may write to it
    kStaleResultAccepted,  ///< a coordinator that lost a job may end it with its result
    kRenewIgnored,         ///< renewals are acknowledged but not written
    kLostClaimRenewed,     ///< a coordinator that lost a job may renew its lease
    kRequestIdIgnored,     ///< each Create makes a job
    kRequestIdOfAll,       ///< a request_id of one tenant is valid for all tenants
    kQueueUnbounded,       ///< tenants may have any number of jobs
    kCreateNotWritten,     ///< Create is acknowledged but not written
    kHandBackNotWritten,   ///< QUEUED is acknowledged but not written
    kEndNotWritten,        ///< SUCCEEDED is acknowledged but not written
    kCancelNotWritten,     ///< cancel requests are acknowledged but not written
    kCancelForgotten,      ///< renewals do not report that a job is to end
    kAdoptionNotWritten,   ///< adoptions are acknowledged but not written
    kHeldJobsClaimed,      ///< a claim takes a job that another coordinator holds
    kSameWorkClaimed,      ///< a claim takes a job although another job of the same work is held
    kPriorityIgnored,      ///< the oldest job of a tenant is claimed first
    kTenantsIgnored,       ///< the tenants' turns are not kept
    kSomeNeverClaimed,     ///< the jobs of some work are never claimed
    kEventsSkipped,        ///< a reader of events misses one
    kLostRunsForgotten,    ///< the number of lost runs of a job is not written
    kReferencesForgotten,  ///< artifacts of jobs are reported as unused
  };

  FlawedStore(JobStore& store, Flaw flaw) : ForwardingJobStore(store), flaw_(flaw) {}

  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override {
    NewJob made = job;
    if (flaw_ == Flaw::kRequestIdIgnored) made.request_id.clear();
    if (flaw_ == Flaw::kRequestIdOfAll) {
      const auto& [id, first] = *first_tenants_.try_emplace(job.request_id, job.tenant).first;
      made.tenant = first;
    }
    if (flaw_ == Flaw::kQueueUnbounded) made.max_open = INT64_MAX;
    if (flaw_ == Flaw::kPriorityIgnored) made.priority = Priority::kNormal;
    absl::StatusOr<Created> created =
        flaw_ == Flaw::kCreateNotWritten ? Unwritten(job) : store().Create(made, now_us);
    return created;
  }
  absl::StatusOr<std::optional<JobRecord>> Claim(const std::string& owner, int64_t now_us,
                                                 int64_t until_us,
                                                 const ClaimFilter& filter) override {
    const int64_t ahead_us = flaw_ == Flaw::kHeldJobsClaimed ? 10'000'000 : 0;
    // Another coordinator holds the next job for a moment.
    if (flaw_ == Flaw::kTenantsIgnored)
      store().Claim("nobody", now_us, now_us + 1, filter).IgnoreError();
    std::vector<JobRecord> held;
    if (flaw_ == Flaw::kSameWorkClaimed) held = HeldBySomebody(now_us);
    for (const JobRecord& job : held) CallItsWork(job, "other work", now_us);
    auto claimed = store().Claim(owner, now_us + ahead_us, until_us, filter);
    for (const JobRecord& job : held) CallItsWork(job, job.action_digest, now_us);
    const bool some = claimed.ok() && *claimed && (*claimed)->action_digest == "a0-b1";
    if (flaw_ == Flaw::kSomeNeverClaimed && some) return std::nullopt;
    return claimed;
  }
  absl::StatusOr<bool> Adopt(const Lease& lease, const JobIdentity& identity,
                             int64_t now_us) override {
    if (flaw_ == Flaw::kAdoptionNotWritten) return true;
    return store().Adopt(lease, identity, now_us);
  }
  absl::StatusOr<std::vector<HeldJob>> Renew(const std::vector<Lease>& leases,
                                             int64_t until_us) override {
    if (flaw_ == Flaw::kRenewIgnored) return AllHeld(leases);
    if (flaw_ == Flaw::kLostClaimRenewed) {
      std::vector<Lease> present;
      for (const Lease& lease : leases) present.push_back(Present(lease));
      const auto held = store().Renew(present, until_us);
      return held.ok() ? AllHeld(leases) : held;
    }
    auto held = store().Renew(leases, until_us);
    if (flaw_ != Flaw::kCancelForgotten || !held.ok()) return held;
    for (HeldJob& job : *held) job.cancel_requested = false;
    return held;
  }
  absl::StatusOr<JobRecord> Update(const Lease& lease, const JobUpdate& update,
                                   int64_t now_us) override {
    if (flaw_ == Flaw::kLostRunsForgotten) return store().Update(lease, Uncounted(update), now_us);
    const bool unwritten =
        (flaw_ == Flaw::kHandBackNotWritten && update.state == JobState::kQueued) ||
        (flaw_ == Flaw::kEndNotWritten && update.state == JobState::kSucceeded);
    if (unwritten) return store().Get(lease.job_id);
    const bool unfenced = flaw_ == Flaw::kNoFencing || (flaw_ == Flaw::kStaleResultAccepted &&
                                                        update.state == JobState::kSucceeded);
    return store().Update(unfenced ? Present(lease) : lease, update, now_us);
  }
  absl::StatusOr<JobRecord> RequestCancel(const std::string& id, int64_t now_us) override {
    if (flaw_ == Flaw::kCancelNotWritten) return store().Get(id);
    return store().RequestCancel(id, now_us);
  }
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override {
    auto events = store().Events(id, after, limit);
    if (flaw_ == Flaw::kEventsSkipped && events.ok() && events->size() > 1) {
      events->erase(events->begin());
    }
    return events;
  }
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override {
    auto referenced = store().Referenced(tenant, digests);
    if (flaw_ != Flaw::kReferencesForgotten || !referenced.ok()) return referenced;
    std::erase_if(*referenced, [](const std::string& digest) { return digest[0] == 'g'; });
    return referenced;
  }

 private:
  static Created Unwritten(const NewJob& job) {
    Created created;
    created.job.id = job.id;
    created.job.tenant = job.tenant;
    created.job.priority = job.priority;
    created.job.deadline_us = job.deadline_us;
    created.job.spec = job.spec;
    created.job.action_digest = job.action_digest;
    created.job.build_id = job.build_id;
    return created;
  }

  static JobUpdate Uncounted(JobUpdate update) {
    update.lost_runs = 0;
    return update;
  }

  static std::vector<HeldJob> AllHeld(const std::vector<Lease>& leases) {
    std::vector<HeldJob> held;
    for (const Lease& lease : leases) held.push_back({lease, false});
    return held;
  }

  Lease Present(const Lease& lease) {
    const auto job = store().Get(lease.job_id);
    return job.ok() ? Lease{lease.job_id, job->owner_epoch} : lease;
  }

  std::vector<JobRecord> HeldBySomebody(int64_t now_us) {
    std::vector<JobRecord> held = *store().List(
        {.all_tenants = true, .states = {JobState::kQueued, JobState::kRunning}, .limit = 1000});
    std::erase_if(held, [&](const JobRecord& job) {
      return job.owner.empty() || job.owner_until_us <= now_us;
    });
    return held;
  }
  void CallItsWork(const JobRecord& job, const std::string& action, int64_t now_us) {
    const JobIdentity identity = {job.settings_digest, action, job.build_id};
    store().Adopt({job.id, job.owner_epoch}, identity, now_us).IgnoreError();
  }

  const Flaw flaw_;
  std::map<std::string, std::string> first_tenants_;  ///< first tenant by request id
};

}  // namespace slicefarm::coordinator::sim
