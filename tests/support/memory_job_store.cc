#include "tests/support/memory_job_store.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator {
namespace {

using Lock = std::lock_guard<std::mutex>;

/// Replaces the record by `job` and adds an event with it.
void WriteStep(MemoryJobs::Entry& entry, JobRecord job, int64_t now_us) {
  ++job.last_sequence;
  entry.events.push_back({job.last_sequence, now_us, job.state, job.layers_total, job.layers_done});
  entry.job = std::move(job);
}

JobRecord WithoutSpec(JobRecord job) {
  job.spec.clear();
  return job;
}

/// Returns true if the job refers to this blob of the tenant.
bool RefersTo(const JobRecord& job, const std::string& tenant, const std::string& digest) {
  if (job.trace_sha256 == digest && job.tenant == tenant) return true;
  return job.result && job.result->tenant == tenant &&
         (job.result->gcode_sha256 == digest || job.result->report_sha256 == digest);
}

bool IsWanted(const JobRecord& job, const ListQuery& query) {
  if (!query.all_tenants && job.tenant != query.tenant) return false;
  if (query.priority && job.priority != *query.priority) return false;
  if (job.create_us < query.created_from_us || job.create_us >= query.created_before_us) {
    return false;
  }
  const bool after =
      query.oldest_first ? job.number > query.after_number : job.number < query.after_number;
  if (query.after_number > 0 && !after) return false;
  const auto& states = query.states;
  if (!states.empty() && std::find(states.begin(), states.end(), job.state) == states.end()) {
    return false;
  }
  return std::includes(job.labels.begin(), job.labels.end(), query.labels.begin(),
                       query.labels.end());
}

/// Returns the sort key for the order of a tenant's jobs.
std::tuple<int, int64_t, int64_t> Urgency(const JobRecord& job) {
  return {-static_cast<int>(job.priority), job.deadline_us, job.number};
}

}  // namespace

const MemoryJobs::Entry* MemoryJobs::Find(const std::string& id) const {
  const auto number = numbers_.find(id);
  return number == numbers_.end() ? nullptr : &entries_.at(number->second);
}

MemoryJobStore::Entry* MemoryJobStore::Find(const std::string& id) {
  const auto number = jobs_.numbers_.find(id);
  return number == jobs_.numbers_.end() ? nullptr : &jobs_.entries_.at(number->second);
}

/// Returns the lease's job if the lease is the current one.
MemoryJobStore::Entry* MemoryJobStore::FindHeld(const Lease& lease) {
  Entry* entry = Find(lease.job_id);
  const bool held = entry && entry->job.owner_epoch == lease.epoch && !entry->job.owner.empty();
  return held ? entry : nullptr;
}

/// Returns QUEUE_FULL if the tenant may have no further job. `before`: number of jobs that are
/// about to be made.
absl::Status MemoryJobStore::CheckQueue(const NewJob& job, int64_t before) const {
  int64_t open = before;
  for (const auto& [number, entry] : jobs_.entries_) {
    if (entry.job.tenant == job.tenant && !IsTerminal(entry.job.state)) ++open;
  }
  return open >= job.max_open ? QueueFull(job.max_open) : absl::OkStatus();
}

absl::StatusOr<Created> MemoryJobStore::Create(const NewJob& job, int64_t now_us) {
  auto all = CreateAll({job}, now_us);
  if (!all.ok()) return all.status();
  return std::move(all->front());
}

absl::StatusOr<std::vector<Created>> MemoryJobStore::CreateAll(const std::vector<NewJob>& jobs,
                                                               int64_t now_us) {
  Lock lock(jobs_.mutex_);
  std::vector<std::optional<Created>> earlier;
  int64_t fresh = 0;
  for (const NewJob& job : jobs) {
    auto found = FindEarlier(job);
    if (!found.ok()) return found.status();
    earlier.push_back(*std::move(found));
    if (earlier.back()) continue;
    if (!job.refusal.ok()) return job.refusal;
    if (absl::Status ok = CheckQueue(job, fresh++); !ok.ok()) return ok;
  }
  std::vector<Created> all;
  for (size_t i = 0; i < jobs.size(); ++i)
    all.push_back(earlier[i] ? *std::move(earlier[i]) : Insert(jobs[i], now_us));
  return all;
}

/// Returns the job of an earlier call with the same request id, if there was one.
absl::StatusOr<std::optional<Created>> MemoryJobStore::FindEarlier(const NewJob& job) {
  const auto earlier = jobs_.requests_.find({job.tenant, job.request_id});
  if (earlier == jobs_.requests_.end()) return std::nullopt;
  if (earlier->second.spec_digest != job.spec_digest) return RequestIdReused(job.request_id);
  return Created{Find(earlier->second.job_id)->job, /*fresh=*/false};
}

Created MemoryJobStore::Insert(const NewJob& job, int64_t now_us) {
  if (!job.request_id.empty())
    jobs_.requests_[{job.tenant, job.request_id}] = {job.id, job.spec_digest, now_us};
  JobRecord record;
  record.number = ++jobs_.last_number_;
  record.id = job.id;
  record.tenant = job.tenant;
  record.priority = job.priority;
  record.deadline_us = job.deadline_us;
  record.spec = job.spec;
  record.labels = job.labels;
  record.settings_digest = job.settings_digest;
  record.action_digest = job.action_digest;
  record.build_id = job.build_id;
  record.traceparent = job.traceparent;
  record.create_us = now_us;
  jobs_.numbers_[job.id] = record.number;
  Entry& entry = jobs_.entries_[record.number];
  entry.inputs = job.inputs;
  WriteStep(entry, std::move(record), now_us);
  return {entry.job, /*fresh=*/true};
}

absl::StatusOr<JobRecord> MemoryJobStore::Get(const std::string& id) {
  Lock lock(jobs_.mutex_);
  const Entry* entry = Find(id);
  return entry ? absl::StatusOr<JobRecord>(entry->job) : JobNotFound(id);
}

absl::StatusOr<std::string> MemoryJobStore::TenantOf(const std::string& id) {
  Lock lock(jobs_.mutex_);
  const Entry* entry = Find(id);
  return entry ? absl::StatusOr<std::string>(entry->job.tenant) : JobNotFound(id);
}

absl::StatusOr<std::vector<JobRecord>> MemoryJobStore::List(const ListQuery& query) {
  Lock lock(jobs_.mutex_);
  std::vector<JobRecord> list;
  for (const auto& [number, entry] : jobs_.entries_) {
    if (IsWanted(entry.job, query)) list.push_back(entry.job);
  }
  if (!query.oldest_first) std::reverse(list.begin(), list.end());
  list.resize(std::min(list.size(), static_cast<size_t>(query.limit)));
  int64_t bytes = 0;
  const auto end = std::ranges::find_if(list, [&](const JobRecord& job) {
    const bool full = bytes >= kListedSpecBytes;
    bytes += std::ssize(job.spec);
    return full;
  });
  list.erase(end, list.end());
  return list;
}

/// Returns the tenants with open jobs, in the order of their turns, as far as `filter` accepts
/// them.
std::vector<std::string> MemoryJobStore::Tenants(int64_t now_us, const ClaimFilter& filter) const {
  std::map<std::string, int64_t> held;
  for (const auto& [number, entry] : jobs_.entries_) {
    const JobRecord& job = entry.job;
    if (IsTerminal(job.state)) continue;
    held[job.tenant] += !job.owner.empty() && job.owner_until_us > now_us;
  }
  std::vector<std::tuple<int64_t, int64_t, std::string>> turns;
  for (const auto& [tenant, count] : held) {
    if (filter.of_idle_tenants && count > 0) continue;
    const auto turn = jobs_.turns_.find(tenant);
    turns.emplace_back(count, turn == jobs_.turns_.end() ? 0 : turn->second, tenant);
  }
  std::sort(turns.begin(), turns.end());
  std::vector<std::string> tenants;
  for (auto& [count, turn_us, tenant] : turns) tenants.push_back(std::move(tenant));
  return tenants;
}

/// Returns the action digests of jobs that have an owner and are not to be cancelled.
std::set<std::string> MemoryJobStore::HeldWork(int64_t now_us, const std::string& but_job) const {
  std::set<std::string> held;
  for (const auto& [number, entry] : jobs_.entries_) {
    const JobRecord& job = entry.job;
    const bool works = !job.owner.empty() && job.owner_until_us > now_us && !job.cancel_requested;
    if (works && job.id != but_job) held.insert(job.action_digest);
  }
  return held;
}

/// Returns the tenant's next job; nullptr if none may be claimed.
JobRecord* MemoryJobStore::Claimable(const std::string& tenant, int64_t now_us,
                                     const ClaimFilter& filter) {
  const std::set<std::string> held = HeldWork(now_us);
  JobRecord* first = nullptr;
  for (auto& [number, entry] : jobs_.entries_) {
    JobRecord& job = entry.job;
    const bool claimable = job.tenant == tenant && !IsTerminal(job.state) &&
                           job.priority >= filter.at_least && job.owner_until_us <= now_us &&
                           (job.cancel_requested || !held.contains(job.action_digest));
    if (claimable && (!first || Urgency(job) < Urgency(*first))) first = &job;
  }
  return first;
}

absl::StatusOr<std::optional<JobRecord>> MemoryJobStore::Claim(const std::string& owner,
                                                               int64_t now_us, int64_t until_us,
                                                               const ClaimFilter& filter) {
  Lock lock(jobs_.mutex_);
  for (const std::string& tenant : Tenants(now_us, filter)) {
    JobRecord* job = Claimable(tenant, now_us, filter);
    if (!job) continue;
    job->owner = owner;
    ++job->owner_epoch;
    job->owner_until_us = until_us;
    jobs_.turns_[tenant] = now_us;
    return *job;
  }
  return std::nullopt;
}

absl::StatusOr<std::vector<JobRecord>> MemoryJobStore::EndOverdue(const JobError& error,
                                                                  int64_t now_us, int32_t limit) {
  Lock lock(jobs_.mutex_);
  std::vector<JobRecord> overdue;
  for (const auto& [number, entry] : jobs_.entries_) {
    JobRecord job = entry.job;
    if (ApplyOverdue(job, error, now_us)) overdue.push_back(std::move(job));
  }
  std::ranges::sort(overdue, {},
                    [](const JobRecord& job) { return std::pair(job.deadline_us, job.number); });
  overdue.resize(std::min(overdue.size(), static_cast<size_t>(limit)));
  for (JobRecord& job : overdue) {
    Entry& entry = *Find(job.id);
    WriteStep(entry, job, now_us);
    job = WithoutSpec(entry.job);
  }
  return overdue;
}

absl::StatusOr<bool> MemoryJobStore::Adopt(const Lease& lease, const JobIdentity& identity,
                                           int64_t now_us) {
  Lock lock(jobs_.mutex_);
  Entry* entry = FindHeld(lease);
  if (!entry) return NotHeld(lease);
  entry->job.settings_digest = identity.settings_digest;
  entry->job.action_digest = identity.action_digest;
  entry->job.build_id = identity.build_id;
  entry->job.lost_runs = 0;
  entry->job.deadly_runs = 0;
  return !HeldWork(now_us, lease.job_id).contains(identity.action_digest);
}

absl::StatusOr<std::vector<HeldJob>> MemoryJobStore::Renew(const std::vector<Lease>& leases,
                                                           int64_t until_us) {
  Lock lock(jobs_.mutex_);
  std::vector<HeldJob> held;
  for (const Lease& lease : leases) {
    Entry* entry = FindHeld(lease);
    if (!entry || IsTerminal(entry->job.state)) continue;
    entry->job.owner_until_us = std::max(entry->job.owner_until_us, until_us);
    held.push_back({lease, entry->job.cancel_requested, entry->job.deadline_us});
  }
  return held;
}

absl::Status MemoryJobStore::Release(const std::string& owner) {
  Lock lock(jobs_.mutex_);
  for (auto& [number, entry] : jobs_.entries_) {
    if (entry.job.owner != owner) continue;
    entry.job.owner.clear();
    entry.job.owner_until_us = 0;
  }
  return absl::OkStatus();
}

absl::StatusOr<JobRecord> MemoryJobStore::Update(const Lease& lease, const JobUpdate& update,
                                                 int64_t now_us) {
  Lock lock(jobs_.mutex_);
  Entry* entry = Find(lease.job_id);
  if (!entry) return JobNotFound(lease.job_id);
  JobRecord job = entry->job;
  if (absl::Status done = ApplyUpdate(job, lease, update, now_us); !done.ok()) return done;
  if (job.result) {
    if (absl::Status done = IndexResult(job); !done.ok()) return done;
  }
  WriteStep(*entry, std::move(job), now_us);
  return WithoutSpec(entry->job);
}

/// Adds a new result to the index of results. A cached result must still be in the index.
absl::Status MemoryJobStore::IndexResult(const JobRecord& job) {
  if (!job.result->cached) {
    jobs_.results_[job.action_digest] = *job.result;
    return absl::OkStatus();
  }
  // A quote, which has no G-code, may have taken the report of a print.
  const JobResult& taken = *job.result;
  const bool there = std::ranges::any_of(jobs_.results_, [&](const auto& entry) {
    const JobResult& kept = entry.second;
    return kept.tenant == taken.tenant && kept.report_sha256 == taken.report_sha256 &&
           (taken.gcode_sha256.empty() || kept.gcode_sha256 == taken.gcode_sha256);
  });
  return there ? absl::OkStatus() : CachedResultGone(job.id);
}

absl::StatusOr<JobRecord> MemoryJobStore::RequestCancel(const std::string& id, int64_t now_us) {
  Lock lock(jobs_.mutex_);
  Entry* entry = Find(id);
  if (!entry) return JobNotFound(id);
  JobRecord job = entry->job;
  if (ApplyCancel(job, now_us)) WriteStep(*entry, std::move(job), now_us);
  return WithoutSpec(entry->job);
}

absl::StatusOr<JobRecord> MemoryJobStore::Change(const std::string& id, const JobChanging& changing,
                                                 int64_t now_us) {
  Lock lock(jobs_.mutex_);
  Entry* entry = Find(id);
  if (!entry) return JobNotFound(id);
  JobRecord job = entry->job;
  ApplyChange(job, changing);
  WriteStep(*entry, std::move(job), now_us);
  return WithoutSpec(entry->job);
}

absl::Status MemoryJobStore::Delete(const std::string& id) {
  Lock lock(jobs_.mutex_);
  Entry* entry = Find(id);
  if (!entry) return JobNotFound(id);
  if (!IsTerminal(entry->job.state)) return JobNotFinished(id);
  const JobRecord job = std::move(entry->job);
  std::erase_if(jobs_.requests_, [&](const auto& request) { return request.second.job_id == id; });
  jobs_.entries_.erase(job.number);
  jobs_.numbers_.erase(id);
  for (const auto digest : {&JobResult::gcode_sha256, &JobResult::report_sha256})
    if (job.result) ForgetUnreferenced(job.result->tenant, *job.result.*digest);
  return absl::OkStatus();
}

bool MemoryJobStore::IsArtifact(const std::string& tenant, const std::string& digest) const {
  return std::any_of(jobs_.entries_.begin(), jobs_.entries_.end(),
                     [&](const auto& entry) { return RefersTo(entry.second.job, tenant, digest); });
}

bool MemoryJobStore::IsInput(const std::string& tenant, const std::string& digest) const {
  return std::any_of(jobs_.entries_.begin(), jobs_.entries_.end(), [&](const auto& entry) {
    const std::vector<std::string>& inputs = entry.second.inputs;
    return entry.second.job.tenant == tenant &&
           std::find(inputs.begin(), inputs.end(), digest) != inputs.end();
  });
}

/// Removes results from the index if no job refers to their blob any more.
void MemoryJobStore::ForgetUnreferenced(const std::string& tenant, const std::string& digest) {
  if (digest.empty() || IsArtifact(tenant, digest)) return;
  std::erase_if(jobs_.results_, [&](const auto& entry) {
    const JobResult& result = entry.second;
    return result.tenant == tenant &&
           (result.gcode_sha256 == digest || result.report_sha256 == digest);
  });
}

absl::StatusOr<std::vector<JobRecord>> MemoryJobStore::FindRequested(
    const std::string& tenant, const std::vector<std::string>& request_ids,
    const std::string& spec_digest) {
  Lock lock(jobs_.mutex_);
  std::vector<JobRecord> found;
  for (const std::string& request_id : request_ids) {
    NewJob asked;
    asked.tenant = tenant;
    asked.request_id = request_id;
    asked.spec_digest = spec_digest;
    auto earlier = FindEarlier(asked);
    if (!earlier.ok()) return earlier.status();
    if (*earlier) found.push_back(std::move((*earlier)->job));
  }
  return found;
}

absl::StatusOr<JobRecord> MemoryJobStore::GetWithoutSpec(const std::string& id) {
  auto job = Get(id);
  return job.ok() ? WithoutSpec(*std::move(job)) : job;
}

absl::StatusOr<std::optional<JobResult>> MemoryJobStore::FindResult(
    const std::string& action_digest) {
  Lock lock(jobs_.mutex_);
  const auto found = jobs_.results_.find(action_digest);
  return found == jobs_.results_.end() ? std::nullopt : std::optional(found->second);
}

absl::Status MemoryJobStore::ForgetResult(const std::string& action_digest) {
  Lock lock(jobs_.mutex_);
  jobs_.results_.erase(action_digest);
  return absl::OkStatus();
}

absl::Status MemoryJobStore::ExpireRequestIds(int64_t now_us) {
  Lock lock(jobs_.mutex_);
  std::erase_if(jobs_.requests_, [&](const auto& request) {
    return request.second.create_us < now_us - kRequestIdKeptUs;
  });
  return absl::OkStatus();
}

absl::StatusOr<std::map<JobState, int64_t>> MemoryJobStore::CountEnded() {
  Lock lock(jobs_.mutex_);
  std::map<JobState, int64_t> counts;
  for (const auto& [number, entry] : jobs_.entries_)
    if (IsTerminal(entry.job.state)) ++counts[entry.job.state];
  return counts;
}

absl::StatusOr<int64_t> MemoryJobStore::CountOf(const std::string& tenant) {
  Lock lock(jobs_.mutex_);
  return std::ranges::count_if(
      jobs_.entries_, [&](const auto& entry) { return entry.second.job.tenant == tenant; });
}

absl::StatusOr<std::map<JobState, int64_t>> MemoryJobStore::CountOpenOf(const std::string& tenant) {
  Lock lock(jobs_.mutex_);
  std::map<JobState, int64_t> counts;
  for (const auto& [number, entry] : jobs_.entries_)
    if (!IsTerminal(entry.job.state) && entry.job.tenant == tenant) ++counts[entry.job.state];
  return counts;
}

absl::StatusOr<std::vector<OpenJobs>> MemoryJobStore::CountOpen() {
  Lock lock(jobs_.mutex_);
  std::map<std::pair<JobState, Priority>, OpenJobs> kinds;
  for (const auto& [number, entry] : jobs_.entries_) {
    const JobRecord& job = entry.job;
    if (IsTerminal(job.state)) continue;
    const OpenJobs none = {job.state, job.priority, 0, job.create_us};
    OpenJobs& kind = kinds.try_emplace({job.state, job.priority}, none).first->second;
    ++kind.count;
    kind.oldest_us = std::min(kind.oldest_us, job.create_us);
  }
  std::vector<OpenJobs> open;
  for (const auto& [key, kind] : kinds) open.push_back(kind);
  return open;
}

absl::StatusOr<std::set<std::string>> MemoryJobStore::Referenced(
    const std::string& tenant, const std::set<std::string>& digests) {
  Lock lock(jobs_.mutex_);
  std::set<std::string> referenced = digests;
  std::erase_if(referenced, [&](const std::string& digest) {
    return !IsArtifact(tenant, digest) && !IsInput(tenant, digest);
  });
  return referenced;
}

absl::StatusOr<std::set<std::string>> MemoryJobStore::Artifacts(
    const std::string& tenant, const std::set<std::string>& digests) {
  Lock lock(jobs_.mutex_);
  std::set<std::string> artifacts = digests;
  std::erase_if(artifacts, [&](const std::string& digest) { return !IsArtifact(tenant, digest); });
  return artifacts;
}

absl::StatusOr<std::vector<std::string>> MemoryJobStore::EndedBefore(int64_t time_us,
                                                                     int32_t limit) {
  Lock lock(jobs_.mutex_);
  std::vector<std::pair<int64_t, std::string>> ended;
  for (const auto& [number, entry] : jobs_.entries_) {
    const JobRecord& job = entry.job;
    if (job.end_us > 0 && job.end_us < time_us) ended.emplace_back(job.end_us, job.id);
  }
  std::sort(ended.begin(), ended.end());
  ended.resize(std::min(ended.size(), static_cast<size_t>(limit)));
  std::vector<std::string> ids;
  for (auto& [end_us, id] : ended) ids.push_back(std::move(id));
  return ids;
}

}  // namespace slicefarm::coordinator
