#include "tests/sim/checked_store.h"

#include <algorithm>

#include "common/base/error.h"
#include "services/coordinator/run/lost_runs.h"

namespace slicefarm::coordinator::sim {
namespace {

/// Number of runs without reachable services after which JobRun fails a job.
constexpr int32_t kMaxRetries = 5;

std::string_view Name(JobState state) { return JobStateName(state); }

}  // namespace

CheckedStore::CheckedStore(World& world, JobStore& store, const MemoryJobs& jobs)
    : ForwardingJobStore(store), world_(world), jobs_(jobs) {
  for (const ClientPlan& client : world.scenario.clients) works_[client.work.id] = client.work;
}

void CheckedStore::Acknowledged(const std::string& job_id) {
  acknowledged_.insert(job_id);
  CheckAll();
}

const JobRecord* CheckedStore::Find(const std::string& job_id) const {
  const MemoryJobs::Entry* entry = jobs_.Find(job_id);
  return entry ? &entry->job : nullptr;
}

std::string CheckedStore::Unended() const {
  for (const auto& [number, entry] : jobs_.entries()) {
    if (!IsTerminal(entry.job.state)) return entry.job.id;
  }
  return {};
}

absl::StatusOr<Created> CheckedStore::Create(const NewJob& job, int64_t now_us) {
  const auto found = requests_.find({job.tenant, job.request_id});
  const bool full = IsFull(job);
  auto created = store().Create(job, now_us);
  CheckCreated(job, found == requests_.end() ? nullptr : &found->second, full, created);
  if (created.ok() && created->fresh) {
    ++world_.totals.jobs;
    if (!job.request_id.empty()) {
      requests_[{job.tenant, job.request_id}] = {job.id, job.spec_digest};
    }
    Wrote(created->job);
  }
  CheckAll();
  return created;
}

/// Checks the outcome of Create. `earlier`: the job that the request_id created before, or null.
void CheckedStore::CheckCreated(const NewJob& job, const Requested* earlier, bool full,
                                const absl::StatusOr<Created>& created) {
  const bool reused = earlier && earlier->spec_digest != job.spec_digest;
  if (!created.ok()) {
    const Reason reason = DetailOf(created.status()).reason;
    world_.totals.queue_full += reason == Reason::kQueueFull;
    world_.totals.request_ids_reused += reason == Reason::kRequestIdReused;
    const bool rightly = (reason == Reason::kRequestIdReused && reused) ||
                         (reason == Reason::kQueueFull && full && !earlier);
    if (!rightly) {
      world_.Violated("create of {} refused: {}", job.id, created.status().ToString());
    }
    return;
  }
  if (created->fresh) {
    if (full) world_.Violated("{} exceeds the queue of {}", job.id, job.tenant);
    if (earlier) {
      world_.Violated("request {} made {} and {}", job.request_id, earlier->job_id, job.id);
    }
    return CheckFresh(job, created->job);
  }
  if (!earlier || earlier->job_id != created->job.id || reused) {
    world_.Violated("request {} of {} was answered with {}", job.request_id, job.id,
                    created->job.id);
  }
}

void CheckedStore::CheckFresh(const NewJob& job, const JobRecord& record) {
  const bool as_wanted = record.id == job.id && record.tenant == job.tenant &&
                         record.priority == job.priority && record.deadline_us == job.deadline_us &&
                         record.spec == job.spec && record.action_digest == job.action_digest &&
                         record.build_id == job.build_id;
  if (!as_wanted) world_.Violated("{} is not the job that was asked for", job.id);
}

bool CheckedStore::IsFull(const NewJob& job) const {
  int64_t open = 0;
  for (const auto& [number, entry] : jobs_.entries()) {
    open += entry.job.tenant == job.tenant && !IsTerminal(entry.job.state);
  }
  return open >= job.max_open;
}

absl::StatusOr<std::optional<JobRecord>> CheckedStore::Claim(const std::string& owner,
                                                             int64_t now_us, int64_t until_us,
                                                             const ClaimFilter& filter) {
  const ClaimOrder::Call call = {now_us, filter};
  claim_order_.Before(jobs_.entries(), call);
  auto claimed = store().Claim(owner, now_us, until_us, filter);
  if (claimed.ok()) {
    if (*claimed) CheckClaim(**claimed, owner, now_us);
    const auto wrong = claim_order_.After(call, *claimed ? &**claimed : nullptr);
    if (wrong) world_.Violated("{}", *wrong);
  }
  CheckAll();
  return claimed;
}

void CheckedStore::CheckClaim(const JobRecord& job, const std::string& owner, int64_t now_us) {
  Seen& seen = seen_[job.id];
  const JobRecord& before = seen.job;
  ++world_.totals.claims;
  if (!before.owner.empty() && before.owner != owner) ++world_.totals.takeovers;
  world_.Log("{} claims {} in epoch {}{}", owner, job.id, job.owner_epoch,
             before.owner.empty() ? "" : ", which was " + before.owner + "'s");
  if (IsTerminal(before.state)) world_.Violated("{} was claimed, {}", job.id, Name(before.state));
  if (before.owner_until_us > now_us) world_.Violated("{} was claimed while held", job.id);
  for (const auto& [number, entry] : jobs_.entries()) {
    const JobRecord& other = entry.job;
    const bool held = !other.owner.empty() && other.owner_until_us > now_us && other.id != job.id;
    const bool both_wanted = !other.cancel_requested && !job.cancel_requested;
    if (held && both_wanted && other.action_digest == job.action_digest)
      world_.Violated("{} was claimed while {} has the same done", job.id, other.id);
  }
  if (job.owner_epoch != before.owner_epoch + 1) {
    world_.Violated("{} was claimed in epoch {} after {}", job.id, job.owner_epoch,
                    before.owner_epoch);
  }
  seen.claimed_us = now_us;
}

/// Notifies the listeners of a change.
void CheckedStore::Wrote(const JobRecord& job) {
  world_.changed({job.id, job.state, job.cancel_requested});
}

absl::StatusOr<std::vector<JobRecord>> CheckedStore::EndOverdue(const JobError& error,
                                                                int64_t now_us, int32_t limit) {
  auto ended = store().EndOverdue(error, now_us, limit);
  if (ended.ok()) {
    for (const JobRecord& job : *ended) {
      const JobRecord& before = seen_[job.id].job;
      world_.Log("{} is overdue", job.id);
      const bool held = !before.owner.empty() && before.owner_until_us > now_us;
      if (IsTerminal(before.state) || held || job.deadline_us > now_us) {
        world_.Violated("{} was ended as overdue, and was not", job.id);
      }
      Wrote(job);
    }
  }
  CheckAll();
  return ended;
}

absl::StatusOr<bool> CheckedStore::Adopt(const Lease& lease, const JobIdentity& identity,
                                         int64_t now_us) {
  const auto adopted = store().Adopt(lease, identity, now_us);
  if (adopted.ok()) {
    ++world_.totals.adoptions;
    const JobRecord* job = Find(lease.job_id);
    if (job && job->owner_epoch != lease.epoch) {
      world_.Violated("{} was adopted in epoch {} by epoch {}", job->id, job->owner_epoch,
                      lease.epoch);
    }
  }
  CheckAll();
  return adopted;
}

absl::StatusOr<std::vector<HeldJob>> CheckedStore::Renew(const std::vector<Lease>& leases,
                                                         int64_t until_us) {
  auto held = store().Renew(leases, until_us);
  if (held.ok()) {
    for (const HeldJob& renewed : *held) {
      const JobRecord* job = Find(renewed.lease.job_id);
      if (!job || job->owner_epoch != renewed.lease.epoch || job->owner_until_us < until_us) {
        world_.Violated("{} was said to be held in epoch {}, and is not", renewed.lease.job_id,
                        renewed.lease.epoch);
      }
    }
  }
  CheckAll();
  return held;
}

absl::Status CheckedStore::Release(const std::string& owner) {
  absl::Status released = store().Release(owner);
  world_.Log("{} releases what it held", owner);
  CheckAll();
  return released;
}

absl::StatusOr<JobRecord> CheckedStore::Update(const Lease& lease, const JobUpdate& update,
                                               int64_t now_us) {
  const JobRecord before = Find(lease.job_id) ? *Find(lease.job_id) : JobRecord{};
  auto updated = store().Update(lease, update, now_us);
  world_.Log("{} in epoch {}: {} {}/{}{}{}", lease.job_id, lease.epoch, Name(update.state),
             update.layers_done, update.layers_total,
             update.error ? " " + update.error->reason : "",
             updated.ok() ? "" : ": " + std::string(updated.status().message()));
  if (absl::IsAborted(updated.status())) ++world_.totals.fenced_writes;
  if (updated.ok()) {
    const JobRecord* after = Find(lease.job_id);
    if (before.owner_epoch != lease.epoch || before.owner.empty()) {
      world_.Violated("{} was written in epoch {} by who held it in epoch {}", lease.job_id,
                      before.owner_epoch, lease.epoch);
    }
    const bool ends = before.cancel_requested &&
                      (update.state == JobState::kQueued || update.state == JobState::kSucceeded);
    const JobState state = ends ? JobState::kCancelled : update.state;
    if (!after || after->state != state || after->last_sequence != before.last_sequence + 1) {
      world_.Violated("a write of {} to {} was acknowledged, and is not there", Name(state),
                      lease.job_id);
    } else {
      Wrote(*after);
      if (state != JobState::kRunning && !after->owner.empty()) {
        world_.Violated("{} is {} and still held", lease.job_id, Name(state));
      }
    }
  }
  CheckAll();
  return updated;
}

absl::StatusOr<JobRecord> CheckedStore::RequestCancel(const std::string& id, int64_t now_us) {
  const JobRecord before = Find(id) ? *Find(id) : JobRecord{};
  auto job = store().RequestCancel(id, now_us);
  if (job.ok()) {
    world_.Log("{} is to be cancelled", id);
    const JobRecord* after = Find(id);
    if (!after || (!IsTerminal(after->state) && !after->cancel_requested)) {
      world_.Violated("a request to cancel {} was acknowledged, and is not there", id);
    }
    const bool at_once = before.state == JobState::kQueued && before.owner.empty();
    if (after && after->state != (at_once ? JobState::kCancelled : before.state)) {
      world_.Violated("a request to cancel {} {} made it {}", Name(before.state), id,
                      Name(after->state));
    }
    Wrote(*job);
  }
  CheckAll();
  return job;
}

absl::Status CheckedStore::Delete(const std::string& id) {
  const JobRecord* before = Find(id);
  const bool ended = before && IsTerminal(before->state);
  absl::Status done = store().Delete(id);
  if (done.ok()) {
    world_.Log("{} is deleted", id);
    ++world_.totals.deleted;
    if (!ended) world_.Violated("{} was deleted before its end", id);
    deleted_.insert(id);
    std::erase_if(requests_, [&](const auto& request) { return request.second.job_id == id; });
  }
  CheckAll();
  return done;
}

void CheckedStore::CheckAll() {
  for (const auto& [number, entry] : jobs_.entries()) CheckJob(entry, seen_[entry.job.id]);
  for (const std::string& id : acknowledged_) {
    if (!jobs_.Find(id) && !deleted_.contains(id)) world_.Violated("{} is lost", id);
  }
}

void CheckedStore::CheckJob(const MemoryJobs::Entry& entry, Seen& seen) {
  const JobRecord& job = entry.job;
  if (deleted_.contains(job.id)) world_.Violated("{} is back after its deletion", job.id);
  if (IsTerminal(seen.job.state)) {
    if (job != seen.job) world_.Violated("{} changed after its end", job.id);
  } else {
    if (job.owner_epoch < seen.job.owner_epoch) {
      world_.Violated("the epoch of {} went from {} back to {}", job.id, seen.job.owner_epoch,
                      job.owner_epoch);
    }
    if (job.cancel_requested && seen.cancel_epoch < 0) seen.cancel_epoch = job.owner_epoch;
    CheckEvents(entry, seen);
    if (IsTerminal(job.state)) CheckEnd(job, seen);
    seen.job = job;
  }
  CheckBlobs(entry);
}

void CheckedStore::CheckBlobs(const MemoryJobs::Entry& entry) {
  std::vector<BlobKey> blobs;
  for (const std::string& input : entry.inputs) blobs.push_back({entry.job.tenant, input});
  if (const auto& result = entry.job.result) {
    blobs.push_back({result->tenant, result->gcode_sha256});
    blobs.push_back({result->tenant, result->report_sha256});
  }
  for (const BlobKey& blob : blobs) {
    if (!world_.blobs.Has(blob)) world_.Violated("{} lacks its blob {}", entry.job.id, blob.digest);
  }
}

/// Checks that the events are numbered without gaps, and that each state may follow the one before.
void CheckedStore::CheckEvents(const MemoryJobs::Entry& entry, Seen& seen) {
  for (; seen.events < entry.events.size(); ++seen.events) {
    const JobEventRecord& event = entry.events[seen.events];
    if (event.sequence != static_cast<int64_t>(seen.events) + 1) {
      world_.Violated("event {} of {} has number {}", seen.events + 1, entry.job.id,
                      event.sequence);
    }
    if (seen.events == 0) continue;
    const JobState from = entry.events[seen.events - 1].state;
    if (event.state != from && !MayFollow(from, event.state)) {
      world_.Violated("{} went from {} to {}", entry.job.id, Name(from), Name(event.state));
    }
  }
  if (entry.events.empty() || entry.events.back().state != entry.job.state ||
      entry.job.last_sequence != static_cast<int64_t>(entry.events.size())) {
    world_.Violated("the last event of {} is not its state", entry.job.id);
  }
}

void CheckedStore::CheckEnd(const JobRecord& job, const Seen& seen) {
  const bool cancel_came_first = seen.cancel_epoch >= 0 && seen.cancel_epoch < job.owner_epoch;
  if (cancel_came_first && job.state != JobState::kCancelled) {
    world_.Violated("{} ended as {}, claimed after it was to be cancelled", job.id,
                    Name(job.state));
  }
  if (job.cancel_requested && job.state == JobState::kSucceeded) {
    world_.Violated("{} succeeded, and was to be cancelled", job.id);
  }
  if (job.state == JobState::kSucceeded && seen.claimed_us >= job.deadline_us) {
    world_.Violated("{} succeeded, claimed after its deadline", job.id);
  }
  if (job.state == JobState::kCancelled && !job.cancel_requested) {
    world_.Violated("{} was cancelled, and nobody wanted it", job.id);
  }
  if (job.state == JobState::kFailed) CheckFailure(job, seen);
  if (job.state != JobState::kSucceeded) return;
  const Work& work = works_.at(std::stoll(job.spec));
  if (!job.result || job.result->gcode_sha256 != ExpectedGcode(work, job.build_id)) {
    world_.Violated("{} succeeded with a wrong result", job.id);
  }
}

/// Checks the reason of a FAILED job: a fault of the job, or a long failure of the farm.
void CheckedStore::CheckFailure(const JobRecord& job, const Seen& seen) {
  const std::string reason = job.error ? job.error->reason : "";
  const Work& work = works_.at(std::stoll(job.spec));
  const bool at_fault =
      work.fault == Work::Fault::kBadInput || work.fault == Work::Fault::kBadLayer;
  const bool bad_input = at_fault && reason == ReasonName(Reason::kMeshMalformed);
  const bool away = seen.job.retries == kMaxRetries && reason == ReasonName(Reason::kUnavailable);
  const bool overdue =
      job.end_us >= job.deadline_us && reason == ReasonName(Reason::kDeadlineExceeded);
  // sim_dispatcher.h checks that a range has failed often enough. A job that does not kill
  // coordinators must never be reported as a killer, for any number of killed coordinators.
  const bool kills = work.fault == Work::Fault::kKillsCoordinators;
  const bool condemned =
      kills && reason == ReasonName(Reason::kJobPoisoned) && seen.job.lost_runs >= kMaxLostRuns;
  world_.totals.condemned += condemned;
  const bool poisoned = condemned || reason == ReasonName(Reason::kRangePoisoned);
  if (!bad_input && !away && !overdue && !poisoned) {
    world_.Violated("{} failed with '{}' after {} retries", job.id, reason, seen.job.retries);
  }
}

void CheckedStore::CountEnds() {
  for (const auto& [id, seen] : seen_) {
    world_.totals.succeeded += seen.job.state == JobState::kSucceeded;
    world_.totals.cached += seen.job.result && seen.job.result->cached;
    world_.totals.failed += seen.job.state == JobState::kFailed;
    world_.totals.overdue +=
        seen.job.error && seen.job.error->reason == ReasonName(Reason::kDeadlineExceeded);
    world_.totals.cancelled += seen.job.state == JobState::kCancelled;
  }
}

}  // namespace slicefarm::coordinator::sim
