#include "services/coordinator/server/coordinator.h"

#include <chrono>
#include <utility>

namespace slicefarm::coordinator {
namespace {

int64_t NowUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace

absl::StatusOr<std::unique_ptr<Coordinator>> Coordinator::Open(CoordinatorOptions options,
                                                               const SlicingStage& slicing,
                                                               const MotionStage& motion,
                                                               RangeExecutor& executor,
                                                               const rpc::JsonLog& log) {
  auto stores = OpenStores(options.stores);
  if (!stores.ok()) return stores.status();
  return std::unique_ptr<Coordinator>(
      new Coordinator(std::move(options), *std::move(stores), slicing, motion, executor, log));
}

Coordinator::Coordinator(CoordinatorOptions options, Stores stores, const SlicingStage& slicing,
                         const MotionStage& motion, RangeExecutor& executor,
                         const rpc::JsonLog& log)
    : options_(std::move(options)),
      stores_(std::move(stores)),
      log_(log),
      pipeline_(slicing, motion, executor),
      results_(*stores_.jobs, *stores_.blobs),
      callers_(options_.tenants, NowUs),
      intake_(*stores_.jobs, *stores_.blobs, options_.build_id, options_.sharing, NowUs),
      runner_(RunEnvironment{*stores_.jobs, *stores_.blobs, results_, pipeline_, feed_, NowUs,
                             options_.build_id, options_.sharing, log},
              options_.runner),
      meshes_service_(callers_, *stores_.blobs, options_.transfers),
      jobs_service_(
          JobsBackend{callers_, *stores_.jobs, *stores_.blobs, intake_, runner_, feed_, NowUs, log},
          options_.transfers) {}

Coordinator::~Coordinator() { Stop(); }

absl::Status Coordinator::Start() {
  if (absl::Status started = runner_.Start(); !started.ok()) return started;
  changes_ = ListenForChanges(options_.stores,
                              [this](const std::optional<JobChange>& change) { Changed(change); });
  maintenance_.emplace(*stores_.jobs, *stores_.blobs, options_.maintenance, NowUs, log_);
  return absl::OkStatus();
}

void Coordinator::Stop() {
  maintenance_.reset();
  changes_.reset();
  feed_.Close();
  runner_.Stop();
}

/// Another coordinator, or this one, wrote to a job.
void Coordinator::Changed(const std::optional<JobChange>& change) {
  if (!change) {
    feed_.AllChanged();
    runner_.Wake();
    return;
  }
  feed_.Changed(change->job_id);
  if (change->state == JobState::kQueued) runner_.Wake();
  if (change->cancel_requested) runner_.Cancel(change->job_id);
}

}  // namespace slicefarm::coordinator
