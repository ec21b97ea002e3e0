#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/coordinator/server/jobs_service.h"
#include "services/coordinator/server/meshes_service.h"
#include "services/coordinator/server/state_lock.h"

namespace slicefarm::coordinator {

struct CoordinatorOptions {
  std::string state_dir;
  JobRunnerOptions runner;
  std::string build_id;
  TransferOptions transfers = {};
};

/// The coordinator put together: stores, intake, runner and services over given stages. Its state
/// lives in `state_dir`: jobs.db (SQLite), blobs/, uploads/, lock.
class Coordinator {
 public:
  /// The stages and the executor must outlive it. Errors: those of the stores; Unavailable if
  /// another process uses the directory.
  static absl::StatusOr<std::unique_ptr<Coordinator>> Open(CoordinatorOptions options,
                                                           const SlicingStage& slicing,
                                                           const MotionStage& motion,
                                                           RangeExecutor& executor,
                                                           const rpc::JsonLog& log);
  ~Coordinator();

  /// Begins to run jobs, those of an earlier life first.
  absl::Status Start() { return runner_.Start(); }

  /// Hands running jobs back, and ends the calls that watch.
  void Stop();

  std::vector<grpc::Service*> services() { return {&meshes_service_, &jobs_service_}; }
  JobStore& jobs() { return *jobs_; }

 private:
  Coordinator(CoordinatorOptions options, std::unique_ptr<StateLock> lock,
              std::unique_ptr<JobStore> jobs, std::unique_ptr<BlobStore> blobs,
              const SlicingStage& slicing, const MotionStage& motion, RangeExecutor& executor,
              const rpc::JsonLog& log);

  std::unique_ptr<StateLock> lock_;
  std::unique_ptr<JobStore> jobs_;
  std::unique_ptr<BlobStore> blobs_;
  JobPipeline pipeline_;
  JobResults results_;
  JobFeed feed_;
  JobIntake intake_;
  JobRunner runner_;
  MeshesService meshes_service_;
  JobsService jobs_service_;
};

}  // namespace slicefarm::coordinator
