#include "services/coordinator/algo/pipeline/job_pipeline.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"

namespace slicefarm::coordinator {
namespace {

absl::Status RunTasks(const StageCall& call, PlannedJob& job, Process process,
                      TaskExecutor& executor,
                      const std::function<void(PipelineProgress)>& progress) {
  const int32_t total = job.LayerCount();
  const auto tell = [&](int32_t done) {
    if (progress) progress({.layers_total = total, .layers_done = done});
  };
  tell(0);
  const auto tasks = job.Tasks(executor.Slots(process));
  if (!tasks.ok()) return tasks.status();
  ScopedSpan span(call.spans, "ranges");
  span.Set("layers", absl::StrCat(total));
  span.Set("ranges", absl::StrCat(tasks->size()));
  const auto take = [&](size_t task, TaskResult result) {
    return job.Take(task, std::move(result));
  };
  return executor.Execute(call, *tasks, take, tell);
}

}  // namespace

absl::StatusOr<JobOutput> JobPipeline::Run(
    const StageCall& call, JobInput input,
    const std::function<void(PipelineProgress)>& progress) const {
  const Process kind = input.settings.process;
  const auto process = std::ranges::find(processes_, kind, &JobProcess::process);
  if (process == processes_.end())
    return MakeError(
        absl::StatusCode::kFailedPrecondition, Reason::kProcessUnavailable,
        absl::StrCat("jobs of process ", std::string(ProcessName(kind)), " are not made here"));
  const auto job = (*process)->Plan(call, std::move(input));
  if (!job.ok()) return job.status();
  if (absl::Status made = RunTasks(call, **job, kind, executor_, progress); !made.ok()) return made;
  return (*job)->Assemble(call);
}

}  // namespace slicefarm::coordinator
