#pragma once

#include "common/stage/task.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// slicefarm.v1.Worker as a runner of tasks, of the processes that it told of. Errors as in
/// stage_client.h.
class RemoteWorker : public TaskRunner {
 public:
  /// `replicas` must outlive the worker.
  explicit RemoteWorker(ReplicaSource& replicas, const RemoteOptions& options = {},
                        ProcessSet processes = ProcessSet::All())
      : replicas_(replicas), options_(options), processes_(processes), sends_(options.deadline) {}

  ProcessSet processes() const override { return processes_; }
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  const ProcessSet processes_;
  mutable SharedSends sends_;  // what is under way
};

}  // namespace slicefarm::coordinator
