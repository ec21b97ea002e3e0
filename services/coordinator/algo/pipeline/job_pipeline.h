#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Progress of a job, as weights of its tasks (PlannedJob::Weight). If the process makes layers,
/// the weight of a task is its number of layers.
struct PipelineProgress {
  int32_t total = 0;  ///< weight of all tasks; 0 until the job is planned
  int32_t done = 0;
};

/// Returns the error PROCESS_UNAVAILABLE: this program does not support jobs of the process.
absl::Status ProcessUnavailable(Process process);

/// Makes a program for the machine from meshes. The job's process plans the job, the executor runs
/// its tasks, and the process joins their results. The embedded program and the coordinator use the
/// same pipeline; only the stages and the executor differ.
class JobPipeline {
 public:
  /// Creates a pipeline. `processes`: at most one of each kind. `executor` must outlive the
  /// pipeline.
  JobPipeline(std::vector<std::unique_ptr<JobProcess>> processes, TaskExecutor& executor)
      : processes_(std::move(processes)), executor_(executor) {}

  /// Returns the process of this kind; null if the pipeline does not support it.
  const JobProcess* Find(Process process) const;
  /// Returns the executor that runs the tasks.
  TaskExecutor& executor() const { return executor_; }

  /// Returns the processes that this pipeline supports.
  ProcessSet processes() const {
    ProcessSet all;
    for (const auto& process : processes_) all.Add(process->process());
    return all;
  }

  /// Makes the job's program. Calls `progress` from any thread, one call at a time. Errors: see
  /// JobProcess and TaskExecutor::Execute; PROCESS_UNAVAILABLE if the pipeline does not support the
  /// job's process.
  absl::StatusOr<JobOutput> Run(const StageCall& call, JobInput input,
                                const std::function<void(PipelineProgress)>& progress) const;

 private:
  const std::vector<std::unique_ptr<JobProcess>> processes_;
  TaskExecutor& executor_;
};

}  // namespace slicefarm::coordinator
