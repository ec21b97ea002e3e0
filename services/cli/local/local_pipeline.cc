#include "services/cli/local/local_pipeline.h"

#include <utility>

#include "processes/list/jobs.h"
#include "processes/list/tasks.h"

namespace slicefarm::cli {

LocalPipeline::LocalPipeline(int threads)
    : pipeline_(JobsOver(stages_.all(), /*spool_directory=*/""), dispatcher_) {
  std::vector<std::shared_ptr<const TaskRunner>> chains;
  for (TaskChain& chain : ChainsOver(stages_.all())) chains.push_back(std::move(chain.runner));
  dispatcher_.Join({.name = "here",
                    .tasks = std::make_shared<ProcessRunners>(std::move(chains)),
                    .slots = threads});
}

}  // namespace slicefarm::cli
