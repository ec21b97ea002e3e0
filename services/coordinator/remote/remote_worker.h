#pragma once

#include "common/stage/task.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"

namespace slicefarm {
struct WorkStart;
}

namespace slicefarm::coordinator {

/// slicefarm.v1.Worker as a runner of ranges, of the processes that it told of. Errors as in
/// remote_stages.h.
class RemoteWorker : public TaskRunner {
 public:
  /// `replicas` must outlive the worker.
  explicit RemoteWorker(ReplicaSource& replicas, const RemoteOptions& options = {},
                        ProcessSet processes = ProcessSet::All())
      : replicas_(replicas), options_(options), processes_(processes) {}

  ProcessSet processes() const override { return processes_; }
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const;
  absl::StatusOr<LaserResult> Run(const StageCall& call, const LaserTask& task) const;

 private:
  template <typename Result>
  absl::StatusOr<Result> Ask(const StageCall& call, const WorkStart& start,
                             std::span<const SlicedLayer> layers) const;

  ReplicaSource& replicas_;
  const RemoteOptions options_;
  const ProcessSet processes_;
};

}  // namespace slicefarm::coordinator
