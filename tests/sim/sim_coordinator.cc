#include "tests/sim/sim_coordinator.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/run/run_conclusion.h"
#include "tests/sim/sim_sweep.h"

namespace slicefarm::coordinator::sim {
namespace {

// Values of JobRunnerOptions.
constexpr int kSlots = 4;
constexpr int kInteractiveSlot = 2;
constexpr int kGuestSlot = 3;
constexpr int64_t kLeaseUs = 10 * kSecondUs;
constexpr int64_t kRenewUs = 3 * kSecondUs;
constexpr int64_t kPollUs = kSecondUs;
constexpr int32_t kMaxOverdueAtOnce = 2;
constexpr int64_t kRestartUs = 200 * kMillisecondUs;

}  // namespace

NewJob MakeJob(const ClientPlan& client, const std::string& job_id, const std::string& build) {
  NewJob job;
  job.id = job_id;
  job.tenant = client.tenant;
  job.request_id = client.request_id;
  job.spec = absl::StrCat(client.work.id);
  job.spec_digest = job.spec;
  job.priority = client.priority;
  job.inputs = {MeshOf(client.work)};
  job.action_digest = ActionOf(client.work, build);
  job.build_id = build;
  return job;
}

SimCoordinator::SimCoordinator(World& world, CheckedStore& store, Farm& farm, int index)
    : world_(world),
      store_(store),
      index_(index),
      plan_(world.scenario.coordinators[index]),
      process_(world.events),
      link_(world, process_, store),
      dispatcher_(world, process_, farm, index),
      desk_{world,
            process_,
            link_,
            dispatcher_,
            plan_.build,
            [this] { return NowUs(); },
            [this] { Die(); }} {
  for (const ClientPlan& client : world.scenario.clients) works_[client.work.id] = client.work;
}

void SimCoordinator::Start() {
  process_.Start();
  world_.Log("{} starts", Owner());
  link_.Do([owner = Owner()](JobStore& store) { return store.Release(owner); },
           [this](const absl::Status& released) { Released(released); });
}

void SimCoordinator::Released(const absl::Status& released) {
  if (!released.ok()) return process_.After(kRestartUs, [this] { Start(); });
  leases_.emplace(kLeaseUs);
  calm_since_us_ = NowUs();
  slots_.assign(kSlots, {});
  dispatcher_.Begin();
  for (int slot = 0; slot < kSlots; ++slot) Serve(slot);
  Keep();
  SweepFromTimeToTime();
}

void SimCoordinator::Kill() {
  dispatcher_.End();
  process_.Kill();
  leases_.reset();
  runs_.clear();
  unheard_.clear();
  claims_wanted_.clear();
  claiming_ = false;
  stopping_ = false;
}

/// Kills the coordinator because of its job. It is started again, as by a service manager.
void SimCoordinator::Die() {
  world_.Log("{} dies", Owner());
  ++world_.totals.deaths;
  Kill();
  world_.events.After(kRestartUs, [this] {
    if (!process_.up()) Start();
  });
}

void SimCoordinator::Stop() {
  stopping_ = true;
  leases_->HandBackAll();
  Notice();
  EndIfStopped();
}

void SimCoordinator::EndIfStopped() {
  if (!stopping_ || !runs_.empty() || claiming_) return;
  Kill();
  world_.events.After(kRestartUs, [this] {
    if (!process_.up()) Start();
  });
}

void SimCoordinator::Wake() {
  ++wakes_;
  for (int slot = 0; slot < kSlots; ++slot) {
    if (std::exchange(slots_[slot].idle, false)) Serve(slot);
  }
}

void SimCoordinator::Serve(int slot) {
  if (stopping_) return;
  claims_wanted_.push_back(slot);
  NextClaim();
}

void SimCoordinator::NextClaim() {
  if (claiming_ || claims_wanted_.empty() || stopping_) return EndIfStopped();
  const int slot = claims_wanted_.front();
  claims_wanted_.erase(claims_wanted_.begin());
  Claim(slot);
}

void SimCoordinator::Claim(int slot) {
  claiming_ = true;
  const int64_t now_us = NowUs();
  const ClaimFilter filter = {
      .at_least = slot == kInteractiveSlot ? Priority::kInteractive : Priority::kBulk,
      .of_idle_tenants = slot == kGuestSlot};
  link_.Do([owner = Owner(), now_us, until_us = leases_->UntilUs(now_us),
            filter](JobStore& store) { return store.Claim(owner, now_us, until_us, filter); },
           [this, slot, now_us, seen = wakes_](const Claimed& claimed) {
             Take(slot, now_us, seen, claimed);
           });
}

void SimCoordinator::Take(int slot, int64_t claimed_us, int64_t seen, const Claimed& claimed) {
  if (!claimed.ok() || !*claimed) {
    Nap(slot, seen);
    claiming_ = false;
    return NextClaim();
  }
  if ((*claimed)->build_id != plan_.build) return Adopt(slot, claimed_us, **claimed);
  Run(slot, claimed_us, **claimed);
}

/// Simulates JobRunner::Adopt.
void SimCoordinator::Adopt(int slot, int64_t claimed_us, JobRecord job) {
  const Lease lease{job.id, job.owner_epoch};
  job.action_digest = ActionOf(works_.at(std::stoll(job.spec)), plan_.build);
  job.build_id = plan_.build;
  job.lost_runs = job.deadly_runs = 0;
  const JobIdentity identity{job.settings_digest, job.action_digest, job.build_id};
  link_.Do([lease, identity,
            now_us = NowUs()](JobStore& store) { return store.Adopt(lease, identity, now_us); },
           [this, slot, claimed_us, lease, job](const absl::StatusOr<bool>& adopted) {
             if (adopted.ok() && !*adopted) return PutBack(slot, lease);
             if (adopted.ok()) return Run(slot, claimed_us, job);
             claiming_ = false;
             Nap(slot, wakes_);
             NextClaim();
           });
}

/// Returns the job to the queue, because the same work is held.
void SimCoordinator::PutBack(int slot, const Lease& lease) {
  link_.Do(
      [lease, now_us = NowUs()](JobStore& store) {
        return store.Update(lease, {.state = JobState::kQueued}, now_us).status();
      },
      [this, slot](const absl::Status&) {
        claiming_ = false;
        Nap(slot, wakes_);
        NextClaim();
      });
}

void SimCoordinator::Run(int slot, int64_t claimed_us, const JobRecord& job) {
  const int64_t calm_us = world_.variant.calm_unasked ? INT64_MAX : NowUs() - calm_since_us_;
  const auto run = std::make_shared<SimRun>(desk_, works_.at(std::stoll(job.spec)), job, calm_us);
  if (stopping_) run->wishes()->HandBack();
  leases_->Add(run->lease(), claimed_us, run->wishes());
  runs_[run->lease()] = run;
  claiming_ = false;
  run->Start([this, slot, lease = run->lease()] {
    if (runs_.at(lease)->lost()) calm_since_us_ = NowUs();
    leases_->Remove(lease);
    runs_.erase(lease);
    Serve(slot);
    EndIfStopped();
  });
  NextClaim();
}

/// Waits for a wake, or for the poll interval.
void SimCoordinator::Nap(int slot, int64_t seen) {
  Slot& napping = slots_[slot];
  napping.idle = true;
  const int64_t nap = ++napping.naps;
  process_.After(seen == wakes_ ? kPollUs : 0, [this, slot, nap] {
    Slot& p = slots_[slot];
    if (p.naps == nap && std::exchange(p.idle, false)) Serve(slot);
  });
}

void SimCoordinator::Keep() {
  if (stopping_) return;
  process_.After(kRenewUs, [this] { Keep(); });
  EndOverdue();
  const std::vector<Lease> leases = leases_->ToRenew();
  if (leases.empty()) return;
  const int64_t until_us = leases_->UntilUs(NowUs());
  link_.Do([leases, until_us](JobStore& store) { return store.Renew(leases, until_us); },
           [this, leases, until_us](const auto& held) {
             if (held.ok()) {
               leases_->Renewed(leases, *held, until_us);
             } else {
               leases_->GiveUpLate(NowUs());
             }
             for (const auto& [lease, run] : runs_) {
               held.ok() ? CheckHeard(*run) : CheckGivenUp(*run);
             }
             Notice();
           });
}

void SimCoordinator::EndOverdue() {
  link_.Do(
      [now_us = NowUs()](JobStore& store) {
        return store.EndOverdue(DeadlinePassed(), now_us, kMaxOverdueAtOnce).status();
      },
      [](const absl::Status&) {});
}

/// Checks that the run has learned the news of the last renewal: a lost lease or a cancel request.
/// A change after one renewal must be learned by the next one.
void SimCoordinator::CheckHeard(const SimRun& run) {
  const JobRecord* job = store_.Find(run.lease().job_id);
  const bool held = job && job->owner_epoch == run.lease().epoch && job->owner == Owner();
  const RunRequests& wishes = *run.wishes();
  std::string news;
  if (!held && !wishes.lost()) news = "not its own any more";
  if (held && job->cancel_requested && !wishes.GivenUp(NowUs())) news = "to be cancelled";
  std::string& missed = unheard_[run.lease()];
  if (!news.empty() && news == missed) {
    world_.Violated("{} does not hear that {} is {}", Owner(), run.lease().job_id, news);
  }
  missed = news;
}

/// Checks that a run ends before its lease expires if the store is unreachable.
void SimCoordinator::CheckGivenUp(const SimRun& run) {
  const JobRecord* job = store_.Find(run.lease().job_id);
  if (!job || job->owner_epoch != run.lease().epoch || job->owner != Owner()) return;
  if (NowUs() > job->owner_until_us - kLeaseUs / 5 && !run.wishes()->lost()) {
    world_.Violated("{} works on {} while its claim runs out", Owner(), job->id);
  }
}

/// Sweeps at random intervals, like Maintenance.
void SimCoordinator::SweepFromTimeToTime() {
  process_.After(world_.random.Between(0, 2 * world_.scenario.sweep_every_us), [this] {
    const auto swept = SweepInTime(world_, process_, store_, NowUs());
    if (swept.ok()) world_.totals.swept_blobs += swept->blobs;
    if (!absl::IsCancelled(swept.status())) SweepFromTimeToTime();
  });
}

void SimCoordinator::Notice() {
  for (const auto& [lease, run] : runs_) run->Notice();
}

/// Simulates JobIntake.
void SimCoordinator::Create(const ClientPlan& client, const std::string& job_id,
                            const ReplyTo& reply) {
  NewJob job = MakeJob(client, job_id, plan_.build);
  job.max_open = world_.scenario.max_open;
  if (client.deadline_us) {
    job.deadline_us = World::kBeginUs + client.begin_us + *client.deadline_us;
  }
  if (!world_.blobs.Keep({job.tenant, job.inputs.front()}, world_.wall_us())) {
    return reply(MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBlobNotFound,
                           "the mesh was not uploaded"));
  }
  link_.Do([job, now_us = NowUs()](JobStore& store) { return store.Create(job, now_us); },
           [this, reply](const absl::StatusOr<Created>& created) {
             if (!created.ok()) return reply(created.status());
             reply(Reply{.job = created->job});
             if (created->fresh) Wake();
           });
}

void SimCoordinator::Cancel(const std::string& job_id, const ReplyTo& reply) {
  link_.Do(
      [job_id, now_us = NowUs()](JobStore& store) { return store.RequestCancel(job_id, now_us); },
      [this, job_id, reply](const absl::StatusOr<JobRecord>& job) {
        if (!job.ok()) return reply(job.status());
        leases_->Cancel(job_id);
        Notice();
        reply(Reply{.job = *job});
      });
}

void SimCoordinator::Delete(const std::string& job_id, const ReplyTo& reply) {
  link_.Do([job_id](JobStore& store) { return store.Delete(job_id); },
           [reply](const absl::Status& deleted) {
             if (!deleted.ok()) return reply(deleted);
             reply(Reply());
           });
}

void SimCoordinator::Events(const std::string& job_id, int64_t after, const ReplyTo& reply) {
  link_.Do([job_id, after](JobStore& store) { return store.Events(job_id, after, 100); },
           [reply](const absl::StatusOr<std::vector<JobEventRecord>>& events) {
             if (!events.ok()) return reply(events.status());
             reply(Reply{.events = *events});
           });
}

/// Simulates Coordinator::Changed.
void SimCoordinator::Changed(const std::optional<JobChange>& change) {
  if (!Serving()) return;
  if (!change || change->state == JobState::kQueued) Wake();
  if (!change || !change->cancel_requested) return;
  leases_->Cancel(change->job_id);
  Notice();
}

}  // namespace slicefarm::coordinator::sim
