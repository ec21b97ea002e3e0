#pragma once

#include "common/stage/stages.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"

namespace slicefarm::coordinator {

/// slicefarm.v1.Worker as a runner of ranges. Errors as in remote_stages.h.
class RemoteWorker : public RangeRunner {
 public:
  /// `replicas` must outlive the worker.
  explicit RemoteWorker(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options) {}

  absl::StatusOr<RangeResult> Run(const StageCall& call, const RangeTask& task) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
};

}  // namespace slicefarm::coordinator
