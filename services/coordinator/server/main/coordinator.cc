#include "services/coordinator/server/main/coordinator.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "common/base/stoppable_sleep.h"
#include "processes/list/jobs.h"

namespace slicefarm::coordinator {
namespace {

/// Free space that results of runs need. No run begins with less.
constexpr int64_t kResultSpace = 256 << 20;

constexpr std::chrono::seconds kReportInterval(1);

int64_t NowUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

int64_t SteadyUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

absl::StatusOr<std::unique_ptr<Coordinator>> Coordinator::Open(CoordinatorOptions options,
                                                               const JobStages& stages,
                                                               TaskExecutor& executor,
                                                               const rpc::JsonLog& log) {
  auto stores = OpenStores(options.stores,
                           // + 1: the slot for INTERACTIVE jobs
                           options.runner.jobs + options.runner.guests + 1);
  if (!stores.ok()) return stores.status();
  if (options.spool_dir.empty() && !options.stores.state_dir.empty())
    options.spool_dir = options.stores.state_dir + "/tmp";
  // An unusable spool directory is reported now, not for each job.
  if (const auto spool = SpoolFile::Make(options.spool_dir); !spool.ok()) return spool.status();
  return std::unique_ptr<Coordinator>(
      new Coordinator(std::move(options), *std::move(stores), stages, executor, log));
}

Coordinator::Coordinator(CoordinatorOptions options, Stores stores, const JobStages& stages,
                         TaskExecutor& executor, const rpc::JsonLog& log)
    : options_(std::move(options)),
      stores_(std::move(stores)),
      log_(log),
      jobs_(*stores_.jobs, Registry()),
      runs_(*stores_.runs, Registry()),
      blobs_(*stores_.blobs, Registry()),
      run_blobs_(stores_.run_blobs ? *stores_.run_blobs : *stores_.blobs, Registry()),
      stage_seconds_(Registry()),
      pipeline_(JobsOver(stages.stages, options_.spool_dir), executor),
      memory_(options_.memory_bytes),
      resolved_(options_.build_id),
      results_(runs_, run_blobs_, options_.rates),
      disk_(Guard()),
      budgets_(jobs_, blobs_, SteadyUs),
      full_queues_(SteadyUs),
      callers_(options_.tenants, options_.calls, NowUs),
      intake_(jobs_, blobs_, disk_, budgets_, full_queues_, resolved_, options_.build_id,
              options_.sharing, NowUs, pipeline_.processes()),
      runner_(RunEnvironment{runs_, run_blobs_, resolved_, results_, pipeline_, memory_, feed_,
                             NowUs, options_.build_id, options_.sharing, log,
                             [this](const StageTimes& times) { stage_seconds_.Observe(times); },
                             options_.stages_fit, [this] { return RunsHaveSpace(); }},
              options_.runner),
      presets_(*stores_.preset_bundles),
      meshes_service_(
          {callers_, jobs_, blobs_, disk_, budgets_, full_queues_, stages.projects, memory_, log},
          options_.transfers),
      jobs_service_(JobsBackend{callers_,
                                jobs_,
                                blobs_,
                                intake_,
                                runner_,
                                feed_,
                                *stores_.profiles,
                                *stores_.preset_bundles,
                                presets_,
                                *stores_.webhooks,
                                options_.webhooks,
                                *stages.stages.slicing,
                                stages.arranging,
                                pipeline_,
                                memory_,
                                options_.rates,
                                options_.default_profile,
                                options_.away_stages,
                                NowUs,
                                log},
                    options_.transfers, options_.watches),
      profiles_service_(callers_, *stores_.profiles, disk_, NowUs),
      presets_service_(callers_, *stores_.preset_bundles, presets_, disk_, budgets_, NowUs) {}

DiskGuard Coordinator::Guard() const {
  if (stores_.fill && options_.max_database_bytes > 0)
    return {FreeInDatabase(stores_.fill, options_.max_database_bytes), 0};
  if (stores_.fill || options_.min_free_bytes == 0) return {nullptr, 0};
  return {FreeOnDisk(options_.stores.state_dir), options_.min_free_bytes};
}

/// Returns true if the disks of the state and of the spool have space for the results of runs. The
/// limit is lower than the limit for new data, so that accepted jobs can end.
bool Coordinator::RunsHaveSpace() const {
  const int64_t least = std::min(options_.min_free_bytes, kResultSpace);
  for (const std::string& directory : {options_.stores.state_dir, options_.spool_dir}) {
    if (directory.empty()) continue;
    const auto free = FreeOnDisk(directory)();
    if (free && *free < least) return false;
  }
  return true;
}

prometheus::Registry& Coordinator::Registry() {
  return options_.metrics == nullptr ? unseen_metrics_ : *options_.metrics;
}

Coordinator::~Coordinator() { Stop(); }

absl::Status Coordinator::Start() {
  if (absl::Status started = runner_.Start(); !started.ok()) return started;
  changes_ = ListenForChanges(options_.stores,
                              {[this](const std::optional<JobChange>& change) { Changed(change); },
                               [this](ProgressReport report) {
                                 if (report.owner != options_.runner.owner)
                                   feed_.Progressed(std::move(report));
                               }});
  if (changes_)
    progress_ = std::jthread([this](const std::stop_token& stop) { PublishProgress(stop); });
  webhook_sender_.emplace(*stores_.webhooks, jobs_, options_.webhooks, options_.webhook_sender,
                          NowUs, log_, Registry());
  maintenance_.emplace(jobs_, blobs_, *stores_.profiles, *stores_.preset_bundles,
                       options_.maintenance, NowUs, log_);
  return absl::OkStatus();
}

/// Stops all parts. Begins with the watches, because clients wait for their ends.
void Coordinator::Stop() {
  feed_.Close();
  jobs_service_.EndWatches();
  runner_.Stop();
  progress_ = {};
  changes_.reset();
  maintenance_.reset();
  webhook_sender_.reset();
}

/// Sends the progress of running jobs to the other coordinators every second. The shared store
/// contains the running jobs, but not their progress.
void Coordinator::PublishProgress(const std::stop_token& stop) {
  ProgressReport reported = {options_.runner.owner, {}};
  while (SleepUnlessStopped(stop, kReportInterval)) {
    ProgressReport report = {options_.runner.owner, feed_.Running()};
    if (report == reported) continue;
    changes_->Publish(report);
    reported = std::move(report);
  }
}

/// Handles a change of a job by any coordinator. Without a value, any job may have changed.
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
