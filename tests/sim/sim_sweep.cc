#include "tests/sim/sim_sweep.h"

#include "services/coordinator/store/blobs/swept_blob_store.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"

namespace slicefarm::coordinator::sim {
namespace {

/// Simulated thread of a coordinator that waits for answers.
class Waiter {
 public:
  Waiter(World& world, Process& process)
      : world_(world), process_(process), life_(process.life()) {}

  absl::Status Wait() {
    world_.events.RunUntil(world_.events.now_us() + world_.random.Between(50, 30'000));
    while (Lives() && process_.paused()) world_.events.RunUntil(process_.paused_until_us());
    return Lives() ? absl::OkStatus() : absl::CancelledError("the coordinator died");
  }

 private:
  bool Lives() const { return process_.up() && process_.life() == life_; }

  World& world_;
  Process& process_;
  const int64_t life_;
};

class WaitingJobs : public ForwardingJobStore {
 public:
  WaitingJobs(JobStore& store, Waiter& waiter) : ForwardingJobStore(store), waiter_(waiter) {}

  absl::Status Delete(const std::string& id) override {
    if (absl::Status lives = waiter_.Wait(); !lives.ok()) return lives;
    return store().Delete(id);
  }
  absl::StatusOr<std::set<std::string>> Referenced(const std::string& tenant,
                                                   const std::set<std::string>& digests) override {
    if (absl::Status lives = waiter_.Wait(); !lives.ok()) return lives;
    return store().Referenced(tenant, digests);
  }

 private:
  Waiter& waiter_;
};

/// Part of a tenant's blob store that a sweep needs.
class WaitingBlobs : public SweptBlobStore {
 public:
  WaitingBlobs(World& world, Waiter& waiter, std::string tenant)
      : world_(world), waiter_(waiter), tenant_(std::move(tenant)) {}

  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override {
    if (absl::Status lives = waiter_.Wait(); !lives.ok()) return lives;
    const auto idle_us = static_cast<int64_t>(idle_s * kSecondUs);
    return world_.blobs.Delete({tenant_, digest}, world_.wall_us() - idle_us);
  }
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override {
    for (const auto& [key, used_us] : world_.blobs.used_us()) {
      if (key.tenant != tenant_) continue;
      const auto idle_s = static_cast<double>(world_.wall_us() - used_us) / kSecondUs;
      visit({.digest = key.digest, .size = 1, .complete = true, .idle_s = idle_s});
    }
    return absl::OkStatus();
  }

 private:
  World& world_;
  Waiter& waiter_;
  const std::string tenant_;
};

class WaitingBlobStores : public BlobStores {
 public:
  WaitingBlobStores(World& world, Waiter& waiter) : world_(world), waiter_(waiter) {}

  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) override {
    return std::make_shared<WaitingBlobs>(world_, waiter_, tenant);
  }
  absl::StatusOr<std::vector<std::string>> Tenants() override {
    std::set<std::string> tenants;
    for (const auto& [key, used_us] : world_.blobs.used_us()) tenants.insert(key.tenant);
    return std::vector<std::string>(tenants.begin(), tenants.end());
  }

 private:
  World& world_;
  Waiter& waiter_;
};

}  // namespace

absl::StatusOr<Swept> SweepInTime(World& world, Process& process, JobStore& jobs, int64_t now_us) {
  Waiter waiter(world, process);
  WaitingJobs waiting_jobs(jobs, waiter);
  WaitingBlobStores waiting_blobs(world, waiter);
  const SweepOptions options = {.keep_jobs_s = world.scenario.keep_jobs_s,
                                .keep_blobs_s = world.variant.keep_blobs_s};
  return Sweep(waiting_jobs, waiting_blobs, options, now_us);
}

}  // namespace slicefarm::coordinator::sim
