#pragma once

#include <memory>
#include <vector>

#include "services/cli/local/local_stages.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::cli {

/// Whole pipeline in this program. It calls the stages' algorithms directly, on `threads` threads.
class LocalPipeline {
 public:
  explicit LocalPipeline(int threads);

  const coordinator::JobPipeline& pipeline() const { return pipeline_; }

 private:
  // The order of the members matters: the pipeline refers to the stages and to the dispatcher, and
  // the threads of the dispatcher call the stages.
  const LocalStages stages_;
  coordinator::Dispatcher dispatcher_;
  const coordinator::JobPipeline pipeline_;
};

}  // namespace slicefarm::cli
