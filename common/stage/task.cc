#include "common/stage/task.h"

#include <fmt/core.h>

#include "common/base/error.h"

namespace slicefarm {

TaskLabel LabelOf(LayerRange layers) {
  return {fmt::format("layers {} to {}", layers.first, layers.last - 1),
          {{"layer_first", layers.first}, {"layer_last", layers.last - 1}}};
}

ProcessSet ProcessRunners::processes() const {
  ProcessSet all;
  for (const ProcessInfo& info : kProcesses)
    for (const auto& runner : runners_)
      if (runner->processes().Has(info.process)) all.Add(info.process);
  return all;
}

absl::StatusOr<TaskResult> ProcessRunners::RunTask(const StageCall& call, const Task& task) const {
  for (const auto& runner : runners_)
    if (runner->processes().Has(task.process())) return runner->RunTask(call, task);
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   fmt::format("no jobs of process {} are made here", ProcessName(task.process())));
}

}  // namespace slicefarm
