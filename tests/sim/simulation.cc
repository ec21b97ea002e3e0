#include "tests/sim/simulation.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/sim/checked_store.h"
#include "tests/sim/farm.h"
#include "tests/sim/sim_client.h"
#include "tests/sim/sim_coordinator.h"
#include "tests/sim/world.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::sim {
namespace {

/// Longest delay of a message after the quiet time has begun.
constexpr int64_t kLateUs = 21 * kSecondUs;
/// Longest wait of jobs in the quiet time: the longest delay of a store failure, leases of dead
/// coordinators, and deadlines of calls. The time of their work is added.
constexpr int64_t kWaitUs = 180 * kSecondUs;
/// Longest total wait of a suspect by LostRuns, including the deaths of coordinators between its
/// runs.
constexpr int64_t kCondemnUs = 1100 * kSecondUs;
constexpr int64_t kYesterdayUs = World::kBeginUs - int64_t{24} * 3600 * kSecondUs;

class Simulation {
 public:
  Simulation(uint64_t seed, const Variant& variant,
             const std::function<void(const std::string&)>& trace)
      : world_(seed, variant) {
    world_.trace = trace;
    for (size_t i = 0; i < world_.scenario.coordinators.size(); ++i) {
      coordinators_.push_back(
          std::make_unique<SimCoordinator>(world_, store_, farm_, static_cast<int>(i)));
    }
    for (size_t i = 0; i < world_.scenario.clients.size(); ++i) {
      clients_.push_back(
          std::make_unique<SimClient>(world_, store_, coordinators_, static_cast<int>(i)));
    }
  }

  Outcome Run() {
    for (const auto& coordinator : coordinators_) coordinator->Start();
    for (const BlobKey& mesh : world_.scenario.meshes) world_.blobs.Put(mesh, kYesterdayUs);
    for (size_t i = 0; i < clients_.size(); ++i) Begin(i);
    if (coordinators_.size() > 1 && world_.scenario.changes_told) {
      world_.changed = [this](const JobChange& change) { Announce(change); };
    }
    if (!world_.scenario.faults.empty()) NextFault();
    const int64_t quiet_us = world_.scenario.quiet_from_us;
    world_.events.At(quiet_us, [this] { world_.quiet = true; });
    const int64_t bound_us = quiet_us + kWaitUs + WorkUs() + CondemnedUs();
    while (!world_.violation && !(world_.events.now_us() > quiet_us + kLateUs && AllOver())) {
      world_.events.Step();
      if (world_.events.now_us() > bound_us) world_.Violated("{} does not end", store_.Unended());
    }
    store_.CountEnds();
    for (const auto& coordinator : coordinators_) coordinator->dispatcher().End();
    world_.totals.steps = world_.events.steps();
    world_.totals.simulated_s = world_.events.now_us() / kSecondUs;
    return {world_.violation, world_.totals};
  }

 private:
  void Begin(size_t client) {
    const ClientPlan& plan = world_.scenario.clients[client];
    if (!plan.yesterday) return clients_[client]->Start();
    clients_[client]->StartFromYesterday(MakeYesterday(plan));
  }

  /// Creates a job that was done long ago by a coordinator that does not exist any more.
  std::string MakeYesterday(const ClientPlan& plan) {
    const std::string build = world_.scenario.coordinators.front().build;
    const NewJob job = MakeJob(plan, "yesterday", build);
    JobResult result;
    result.gcode_sha256 = ExpectedGcode(plan.work, build);
    result.report_sha256 = "report-yesterday";
    result.layers = plan.work.layers;
    world_.blobs.Put({job.tenant, job.inputs.front()}, kYesterdayUs);
    for (const std::string& blob : {result.gcode_sha256, result.report_sha256}) {
      world_.blobs.Put({result.tenant, blob}, kYesterdayUs);
    }
    store_.Create(job, kYesterdayUs).IgnoreError();
    store_.Claim("past", kYesterdayUs, kYesterdayUs + kSecondUs, {Priority::kBulk}).IgnoreError();
    store_.Update({job.id, 1}, {.state = JobState::kSucceeded, .result = result}, kYesterdayUs)
        .IgnoreError();
    return job.id;
  }

  /// Notifies all coordinators of a change in their shared store. A coordinator that misses the
  /// notice learns later that changes may have been missed.
  void Announce(const JobChange& change) {
    for (const auto& coordinator : coordinators_) {
      std::optional<JobChange> reported = change;
      int64_t delay_us = world_.random.Between(100, 20'000);
      if (world_.Happens(world_.scenario.lost_permille)) {
        reported.reset();
        delay_us = world_.random.Between(0, 5 * kSecondUs);
      }
      SimCoordinator& to = *coordinator;
      to.process().Arrive(delay_us, [&to, reported] { to.Changed(reported); });
    }
  }

  /// Returns the time until all jobs that kill coordinators are found. It is the sum of the calm
  /// times before each of their runs, because a run of another killing job ends the calm.
  int64_t CondemnedUs() const {
    return kCondemnUs *
           std::ranges::count_if(world_.scenario.clients, [](const ClientPlan& client) {
             return client.work.fault == Work::Fault::kKillsCoordinators;
           });
  }

  /// Returns twice the time of all jobs, one after another on the slowest worker. Jobs with a
  /// poison layer count once per try.
  int64_t WorkUs() const {
    int64_t work_us = 0;
    for (const ClientPlan& client : world_.scenario.clients) {
      const bool poison = client.work.fault == Work::Fault::kPoisonLayer;
      const int tries = poison ? world_.variant.scheduler.max_tries : 2;
      work_us += tries * client.work.layers * client.work.layer_us;
    }
    int slowness = 1;
    for (const WorkerPlan& worker : world_.scenario.workers) {
      slowness = std::max(slowness, worker.slowness);
    }
    return slowness * work_us;
  }

  bool AllOver() const {
    return std::all_of(clients_.begin(), clients_.end(),
                       [](const auto& client) { return client->done(); }) &&
           store_.Unended().empty();
  }

  void NextFault() {
    const int64_t wait_us = world_.random.Between(0, 2 * world_.scenario.fault_every_us);
    world_.events.After(wait_us, [this] {
      if (world_.quiet) return;
      const auto& faults = world_.scenario.faults;
      Happen(faults[world_.random.Below(static_cast<int>(faults.size()))]);
      NextFault();
    });
  }

  /// Returns a random time within the next `most_us`, but not after the start of the quiet time.
  int64_t UntilUs(int64_t most_us) {
    return std::min(world_.events.now_us() + world_.random.Between(50'000, most_us),
                    world_.scenario.quiet_from_us);
  }

  void Happen(Fault fault) {
    const int c = world_.random.Below(static_cast<int>(coordinators_.size()));
    const int w = world_.random.Below(farm_.workers());
    SimCoordinator& coordinator = *coordinators_[c];
    switch (fault) {
      case Fault::kKillCoordinator:
        return Kill(coordinator, c);
      case Fault::kStopCoordinator:
        return Stop(coordinator, c);
      case Fault::kPauseCoordinator:
        world_.Log("c{} is paused", c);
        ++world_.totals.pauses;
        return coordinator.Pause(UntilUs(25 * kSecondUs));
      case Fault::kKillWorker:
        world_.Log("w{} is killed", w);
        ++world_.totals.worker_kills;
        return farm_.Kill(w, world_.random.Between(100, 8000) * kMillisecondUs);
      case Fault::kPauseWorker:
        world_.Log("w{} is paused", w);
        return farm_.Pause(w, UntilUs(25 * kSecondUs));
      case Fault::kPartition:
        world_.Log("c{} and w{} are parted", c, w);
        ++world_.totals.partitions;
        return farm_.Partition(c, w, UntilUs(20 * kSecondUs));
      case Fault::kWorkerLeaves:
        return LeaveAndJoin(coordinator, w);
      case Fault::kStoreAway:
        world_.Log("the store is away");
        world_.store_away_until_us = UntilUs(15 * kSecondUs);
        return;
      case Fault::kDiskFull:
        world_.Log("the disk is full");
        world_.disk_full_until_us = UntilUs(15 * kSecondUs);
        return;
      case Fault::kSlicingAway:
        world_.Log("slicing is away");
        world_.slicing_away_until_us = UntilUs(20 * kSecondUs);
        return;
    }
  }

  void Kill(SimCoordinator& coordinator, int c) {
    if (!coordinator.process().up()) return;
    world_.Log("c{} is killed", c);
    ++world_.totals.kills;
    coordinator.Kill();
    world_.events.After(world_.random.Between(100, 15'000) * kMillisecondUs, [&coordinator] {
      if (!coordinator.process().up()) coordinator.Start();
    });
  }

  void Stop(SimCoordinator& coordinator, int c) {
    coordinator.process().After(0, [this, &coordinator, c] {
      if (!coordinator.Serving()) return;
      world_.Log("c{} stops", c);
      ++world_.totals.stops;
      coordinator.Stop();
    });
  }

  void LeaveAndJoin(SimCoordinator& coordinator, int worker) {
    if (!coordinator.Serving()) return;
    coordinator.process().After(0, [this, &coordinator, worker] {
      if (!coordinator.Serving()) return;
      world_.Log("w{} leaves", worker);
      coordinator.dispatcher().Leave(worker);
      coordinator.process().After(
          world_.random.Between(10, 5000) * kMillisecondUs,
          [&coordinator, worker] { coordinator.dispatcher().Join(worker); });
    });
  }

  World world_;
  MemoryJobs jobs_;
  MemoryJobStore memory_{jobs_};
  std::unique_ptr<JobStore> between_ =
      world_.variant.store ? world_.variant.store(world_, memory_) : nullptr;
  CheckedStore store_{world_, between_ ? *between_ : memory_, jobs_};
  Farm farm_{world_};
  Coordinators coordinators_;
  std::vector<std::unique_ptr<SimClient>> clients_;
};

}  // namespace

Outcome Simulate(uint64_t seed, const Variant& variant,
                 const std::function<void(const std::string&)>& trace) {
  return Simulation(seed, variant, trace).Run();
}

}  // namespace slicefarm::coordinator::sim
