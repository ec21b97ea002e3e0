#include "services/coordinator/server/coordinator.h"

#include <chrono>
#include <utility>

#include "services/coordinator/store/directory_blob_store.h"
#include "services/coordinator/store/posix_file.h"
#include "services/coordinator/store/sqlite_job_store.h"

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
  const std::string directory = options.state_dir;
  if (absl::Status made = MakeDirectory(directory); !made.ok()) return made;
  auto lock = StateLock::Take(directory);
  if (!lock.ok()) return lock.status();
  auto jobs = SqliteJobStore::Open(directory + "/jobs.db");
  if (!jobs.ok()) return jobs.status();
  auto blobs = DirectoryBlobStore::OpenAt(directory);
  if (!blobs.ok()) return blobs.status();
  return std::unique_ptr<Coordinator>(new Coordinator(std::move(options), *std::move(lock),
                                                      *std::move(jobs), *std::move(blobs), slicing,
                                                      motion, executor, log));
}

Coordinator::Coordinator(CoordinatorOptions options, std::unique_ptr<StateLock> lock,
                         std::unique_ptr<JobStore> jobs, std::unique_ptr<BlobStore> blobs,
                         const SlicingStage& slicing, const MotionStage& motion,
                         RangeExecutor& executor, const rpc::JsonLog& log)
    : lock_(std::move(lock)),
      jobs_(std::move(jobs)),
      blobs_(std::move(blobs)),
      pipeline_(slicing, motion, executor),
      results_(*jobs_, *blobs_),
      intake_(*jobs_, *blobs_, options.build_id, NowUs),
      runner_(
          RunEnvironment{*jobs_, *blobs_, results_, pipeline_, feed_, NowUs, options.build_id, log},
          options.runner),
      meshes_service_(*blobs_, options.transfers),
      jobs_service_(JobsBackend{*jobs_, *blobs_, results_, intake_, runner_, feed_, NowUs, log},
                    options.transfers) {}

Coordinator::~Coordinator() { Stop(); }

void Coordinator::Stop() {
  feed_.Close();
  runner_.Stop();
}

}  // namespace slicefarm::coordinator
