#pragma once

#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator {

/// Which progress of a run is worth telling: five times a second and a hundred times a job, at
/// most.
class ProgressGate {
 public:
  /// False: not now. `now_s` on any clock that does not run backwards.
  bool Passes(const PipelineProgress& progress, double now_s);

  /// What passed last.
  const PipelineProgress& told() const { return told_; }

 private:
  PipelineProgress told_;
  double told_at_s_ = 0;
};

}  // namespace slicefarm::coordinator
