#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/server/jobs_service.h"
#include "services/coordinator/server/maintenance.h"
#include "services/coordinator/server/meshes_service.h"
#include "services/coordinator/server/stores.h"

namespace slicefarm::coordinator {

struct CoordinatorOptions {
  StoreOptions stores;
  JobRunnerOptions runner;
  std::string build_id;
  TransferOptions transfers = {};
  Maintenance::Options maintenance = {};
  TenantsNow tenants = {};  ///< none: one tenant without a name
  ResultSharing sharing = ResultSharing::kOff;
};

/// The coordinator put together: stores, intake, runner and services over given stages. Several may
/// share one PostgreSQL database; all of them are active.
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
  absl::Status Start();

  /// Hands running jobs back, and ends the calls that watch.
  void Stop();

  std::vector<grpc::Service*> services() { return {&meshes_service_, &jobs_service_}; }
  JobStore& jobs() { return *stores_.jobs; }

 private:
  Coordinator(CoordinatorOptions options, Stores stores, const SlicingStage& slicing,
              const MotionStage& motion, RangeExecutor& executor, const rpc::JsonLog& log);
  void Changed(const std::optional<JobChange>& change);

  const CoordinatorOptions options_;
  const Stores stores_;
  const rpc::JsonLog log_;
  JobPipeline pipeline_;
  JobResults results_;
  JobFeed feed_;
  const Callers callers_;
  JobIntake intake_;
  JobRunner runner_;
  MeshesService meshes_service_;
  JobsService jobs_service_;
  std::unique_ptr<JobChanges> changes_;
  std::optional<Maintenance> maintenance_;
};

}  // namespace slicefarm::coordinator
