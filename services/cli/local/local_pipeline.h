#pragma once

#include <memory>
#include <vector>

#include "services/cli/local/local_stages.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::cli {

/// Whole pipeline in this process: the stages' algorithms, called directly by `threads` threads.
class LocalPipeline {
 public:
  explicit LocalPipeline(int threads);

  const coordinator::JobPipeline& pipeline() const { return pipeline_; }

 private:
  // The order of these members matters. The pipeline refers to the stages and to the dispatcher,
  // which has threads that run the chains.
  const LocalStages stages_;
  coordinator::Dispatcher dispatcher_;
  const coordinator::JobPipeline pipeline_;
};

}  // namespace slicefarm::cli
