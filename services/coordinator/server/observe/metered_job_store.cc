#include "services/coordinator/server/observe/metered_job_store.h"

#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/base/stopwatch.h"

namespace slicefarm::coordinator {
namespace {

using prometheus::Counter;
using prometheus::Family;
using prometheus::Histogram;
using prometheus::Registry;

/// Bounds of the histogram: from a cached result to the slowest print, and to a night in the queue.
const Histogram::BucketBoundaries kJobSeconds = {0.01, 0.05, 0.1, 0.5, 1,   2.5,  5,
                                                 10,   30,   60,  300, 900, 3600, 14400};
const Histogram::BucketBoundaries kCommitSeconds = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025,
                                                    0.05,   0.1,   0.25,   0.5,   1,    5};

Family<Counter>& CounterFamily(Registry& registry, const std::string& name,
                               const std::string& help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

Family<Histogram>& HistogramFamily(Registry& registry, const std::string& name,
                                   const std::string& help) {
  return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
}

double SecondsBetween(int64_t from_us, int64_t to_us) {
  return static_cast<double>(to_us - from_us) / 1e6;
}

}  // namespace

MeteredJobStore::MeteredJobStore(JobStore& store, Registry& registry)
    : ForwardingJobStore(store),
      submitted_(CounterFamily(registry, "slicefarm_jobs_submitted_total", "Created jobs").Add({})),
      ended_(CounterFamily(registry, "slicefarm_jobs_total", "Ended jobs")),
      job_seconds_(HistogramFamily(registry, "slicefarm_job_seconds",
                                   "Durations of ended jobs: from creation to first run (queue), "
                                   "from there to the end (run), and both (total)")),
      requeued_(CounterFamily(registry, "slicefarm_jobs_requeued_total",
                              "Runs that ended with the job back in the queue, because services or "
                              "stores were unavailable or for another reason")),
      hits_(CounterFamily(registry, "slicefarm_cache_hits_total",
                          "Jobs that ended with the cached result of the same work")
                .Add({})),
      misses_(CounterFamily(registry, "slicefarm_cache_misses_total",
                            "Runs that computed a result because there was no cached one")
                  .Add({})),
      expired_(CounterFamily(registry, "slicefarm_lease_expired_total",
                             "Claims of jobs that another coordinator, or an earlier run of this "
                             "one, left running")
                   .Add({})),
      fenced_(
          CounterFamily(registry, "slicefarm_fenced_writes_total",
                        "Writes that were refused because another coordinator has claimed the job")
              .Add({})),
      commit_seconds_(HistogramFamily(registry, "slicefarm_store_commit_seconds",
                                      "Duration of calls that write to the job store")) {
  // A counter that appears with a 1 looks to Prometheus as if it had never risen.
  for (const char* state : {"SUCCEEDED", "CANCELLED"})
    ended_.Add({{"state", state}, {"reason", ""}});
  for (int reason = 0; reason <= static_cast<int>(Reason::kInternal); ++reason) {
    const std::string_view name = ReasonName(static_cast<Reason>(reason));
    ended_.Add({{"state", "FAILED"}, {"reason", std::string(name)}});
  }
  for (const char* phase : {"queue", "run", "total"})
    job_seconds_.Add({{"phase", phase}}, kJobSeconds);
  for (const char* cause : {"services", "store", "other"}) requeued_.Add({{"cause", cause}});
}

template <typename Call>
auto MeteredJobStore::Timed(const std::string& operation, const Call& call) {
  const Stopwatch watch;
  auto result = call();
  commit_seconds_.Add({{"operation", operation}}, kCommitSeconds).Observe(watch.Seconds());
  return result;
}

absl::StatusOr<Created> MeteredJobStore::Create(const NewJob& job, int64_t now_us) {
  auto created = Timed("create", [&] { return store().Create(job, now_us); });
  if (created.ok() && created->fresh) submitted_.Increment();
  return created;
}

absl::StatusOr<std::vector<Created>> MeteredJobStore::CreateAll(const std::vector<NewJob>& jobs,
                                                                int64_t now_us) {
  auto all = Timed("create_all", [&] { return store().CreateAll(jobs, now_us); });
  if (!all.ok()) return all;
  for (const Created& created : *all)
    if (created.fresh) submitted_.Increment();
  return all;
}

absl::StatusOr<std::optional<JobRecord>> MeteredJobStore::Claim(const std::string& owner,
                                                                int64_t now_us, int64_t until_us,
                                                                const ClaimFilter& filter) {
  const Stopwatch watch;
  auto job = store().Claim(owner, now_us, until_us, filter);
  if (!job.ok() || !*job) return job;  // no write
  commit_seconds_.Add({{"operation", "claim"}}, kCommitSeconds).Observe(watch.Seconds());
  if ((*job)->state == JobState::kRunning) expired_.Increment();
  return job;
}

absl::StatusOr<std::vector<JobRecord>> MeteredJobStore::EndOverdue(const JobError& error,
                                                                   int64_t now_us, int32_t limit) {
  const Stopwatch watch;
  auto ended = store().EndOverdue(error, now_us, limit);
  if (!ended.ok() || ended->empty()) return ended;  // no write
  commit_seconds_.Add({{"operation", "end_overdue"}}, kCommitSeconds).Observe(watch.Seconds());
  for (const JobRecord& job : *ended) Ended(job);
  return ended;
}

absl::StatusOr<bool> MeteredJobStore::Adopt(const Lease& lease, const JobIdentity& identity,
                                            int64_t now_us) {
  auto status = Timed("adopt", [&] { return store().Adopt(lease, identity, now_us); });
  if (absl::IsAborted(status.status())) fenced_.Increment();
  return status;
}

absl::StatusOr<std::vector<HeldJob>> MeteredJobStore::Renew(const std::vector<Lease>& leases,
                                                            int64_t until_us) {
  if (leases.empty()) return store().Renew(leases, until_us);
  return Timed("renew", [&] { return store().Renew(leases, until_us); });
}

absl::StatusOr<JobRecord> MeteredJobStore::Update(const Lease& lease, const JobUpdate& update,
                                                  int64_t now_us) {
  auto job = Timed("update", [&] { return store().Update(lease, update, now_us); });
  if (absl::IsAborted(job.status())) fenced_.Increment();
  if (!job.ok()) return job;
  if (IsTerminal(job->state)) Ended(*job);
  if (job->state == JobState::kQueued) Requeued(update);
  if (update.state == JobState::kRunning && update.layers_total == 0) misses_.Increment();
  if (job->result && job->result->cached) hits_.Increment();
  return job;
}

absl::StatusOr<JobRecord> MeteredJobStore::RequestCancel(const std::string& id, int64_t now_us) {
  auto job = Timed("cancel", [&] { return store().RequestCancel(id, now_us); });
  // In all other cases the job had ended before, or its owner will end it.
  if (job.ok() && job->state == JobState::kCancelled && job->end_us == now_us) Ended(*job);
  return job;
}

absl::Status MeteredJobStore::Delete(const std::string& id) {
  return Timed("delete", [&] { return store().Delete(id); });
}

void MeteredJobStore::Ended(const JobRecord& job) {
  const std::string reason = job.error ? job.error->reason : "";
  ended_.Add({{"state", std::string(JobStateName(job.state))}, {"reason", reason}}).Increment();
  const auto observe = [this](const std::string& phase, int64_t from_us, int64_t to_us) {
    job_seconds_.Add({{"phase", phase}}, kJobSeconds).Observe(SecondsBetween(from_us, to_us));
  };
  const bool ran = job.start_us != 0;
  observe("queue", job.create_us, ran ? job.start_us : job.end_us);
  if (ran) observe("run", job.start_us, job.end_us);
  observe("total", job.create_us, job.end_us);
}

void MeteredJobStore::Requeued(const JobUpdate& update) {
  const char* cause = update.retry ? "services" : update.store_failed ? "store" : "other";
  requeued_.Add({{"cause", cause}}).Increment();
}

}  // namespace slicefarm::coordinator
