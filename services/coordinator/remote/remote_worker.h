#pragma once

#include "common/stage/task.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// TaskRunner that calls slicefarm.v1.Worker. Supports the manufacturing processes (Process) that
/// the worker has reported. Errors: see StageClient.
class RemoteWorker : public TaskRunner {
 public:
  /// Sends the calls to `replicas`, which must outlive the worker.
  explicit RemoteWorker(ReplicaSource& replicas, const RemoteOptions& options = {},
                        ProcessSet processes = ProcessSet::All())
      : replicas_(replicas), options_(options), processes_(processes), sends_(options.deadline) {}

  ProcessSet processes() const override { return processes_; }
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  const ProcessSet processes_;
  mutable SharedSends sends_;  // values that are being sent
};

}  // namespace slicefarm::coordinator
