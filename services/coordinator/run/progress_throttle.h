#pragma once

#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator {

/// Limits the progress reports of a run: at most five per second, and at most a hundred per job.
class ProgressThrottle {
 public:
  /// Returns true if this progress is to be reported now. `now_s` may come from any clock that does
  /// not run backwards.
  bool Passes(const PipelineProgress& progress, double now_s);

  /// Returns the last progress for which Passes returned true.
  const PipelineProgress& reported() const { return reported_; }

 private:
  PipelineProgress reported_;
  double reported_at_s_ = 0;
};

}  // namespace slicefarm::coordinator
