#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// In weights of tasks: layers, for processes that make layers.
struct PipelineProgress {
  int32_t total = 0;  ///< 0 until the job is planned
  int32_t done = 0;
};

/// PROCESS_UNAVAILABLE: nobody here makes jobs of the process.
absl::Status ProcessUnavailable(Process process);

/// The whole way from meshes to a program for the machine: the job's process plans it, the executor
/// makes its tasks, the process puts their results together. The same for the embedded process and
/// for the coordinator; only the stages and the executor differ.
class JobPipeline {
 public:
  /// One process of each kind at most. The executor must outlive the pipeline.
  JobPipeline(std::vector<std::unique_ptr<JobProcess>> processes, TaskExecutor& executor)
      : processes_(std::move(processes)), executor_(executor) {}

  /// The process of that kind, or null: its jobs are not made here.
  const JobProcess* Find(Process process) const;
  TaskExecutor& executor() const { return executor_; }

  /// Whose jobs it makes.
  ProcessSet processes() const {
    ProcessSet all;
    for (const auto& process : processes_) all.Add(process->process());
    return all;
  }

  /// `progress` may be called from any thread, one call at a time.
  /// Errors: those of the process and of the executor; PROCESS_UNAVAILABLE if the job's process
  /// is none of those given.
  absl::StatusOr<JobOutput> Run(const StageCall& call, JobInput input,
                                const std::function<void(PipelineProgress)>& progress) const;

 private:
  const std::vector<std::unique_ptr<JobProcess>> processes_;
  TaskExecutor& executor_;
};

}  // namespace slicefarm::coordinator
