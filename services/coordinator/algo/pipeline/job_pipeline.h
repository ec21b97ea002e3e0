#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/dispatch/task_executor.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

struct PipelineProgress {
  int32_t layers_total = 0;  ///< 0 until the meshes are sliced
  int32_t layers_done = 0;
};

/// The whole way from meshes to a program for the machine: the job's process plans it, the executor
/// makes its tasks, the process puts their results together. The same for the embedded process and
/// for the coordinator; only the stages and the executor differ.
class JobPipeline {
 public:
  /// The processes, one of each kind at most, and the executor must outlive the pipeline.
  JobPipeline(std::vector<const JobProcess*> processes, TaskExecutor& executor)
      : processes_(std::move(processes)), executor_(executor) {}

  /// Whose jobs it makes.
  ProcessSet processes() const {
    ProcessSet all;
    for (const JobProcess* process : processes_) all.Add(process->process());
    return all;
  }

  /// `progress` may be called from any thread, one call at a time.
  /// Errors: those of the process and of the executor; PROCESS_UNAVAILABLE if the job's process
  /// is none of those given.
  absl::StatusOr<JobOutput> Run(const StageCall& call, JobInput input,
                                const std::function<void(PipelineProgress)>& progress) const;

 private:
  const std::vector<const JobProcess*> processes_;
  TaskExecutor& executor_;
};

}  // namespace slicefarm::coordinator
