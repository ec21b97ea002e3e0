#include "services/coordinator/algo/pipeline/job_pipeline.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"

namespace slicefarm::coordinator {
namespace {

absl::Status RunTasks(const StageCall& call, PlannedJob& job, Process process,
                      TaskExecutor& executor,
                      const std::function<void(PipelineProgress)>& progress) {
  const int32_t total = job.Weight();
  const auto tell = [&](int32_t done) {
    if (progress) progress({.total = total, .done = done});
  };
  tell(0);
  const auto tasks = job.Tasks(executor.Slots(process));
  if (!tasks.ok()) return tasks.status();
  ScopedSpan span(call.spans, "ranges");
  span.Set("weight", absl::StrCat(total));
  span.Set("ranges", absl::StrCat(tasks->size()));
  const auto take = [&](size_t task, TaskResult result) {
    return job.Take(task, std::move(result));
  };
  return executor.Execute(call, *tasks, take, tell);
}

}  // namespace

absl::Status ProcessUnavailable(Process process) {
  return MakeError(
      absl::StatusCode::kFailedPrecondition, Reason::kProcessUnavailable,
      absl::StrCat("jobs of process ", std::string(ProcessName(process)), " are not made here"));
}

const JobProcess* JobPipeline::Find(Process process) const {
  for (const auto& one : processes_)
    if (one->process() == process) return one.get();
  return nullptr;
}

absl::StatusOr<JobOutput> JobPipeline::Run(
    const StageCall& call, JobInput input,
    const std::function<void(PipelineProgress)>& progress) const {
  const Process kind = input.settings.process();
  const JobProcess* process = Find(kind);
  if (process == nullptr) return ProcessUnavailable(kind);
  const auto job = process->Plan(call, std::move(input));
  if (!job.ok()) return job.status();
  if (absl::Status made = RunTasks(call, **job, kind, executor_, progress); !made.ok()) return made;
  return (*job)->Assemble(call);
}

}  // namespace slicefarm::coordinator
