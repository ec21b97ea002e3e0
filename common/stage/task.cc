#include "common/stage/task.h"

#include <string>

#include "absl/hash/hash.h"
#include "common/base/error.h"

namespace slicefarm {

void StageTimes::Add(const StageTimes& other) {
  slicing_s += other.slicing_s;
  planning_s += other.planning_s;
  beading_s += other.beading_s;
  infill_s += other.infill_s;
  ordering_s += other.ordering_s;
  motion_s += other.motion_s;
  exposure_s += other.exposure_s;
}

int64_t FdmResult::ProgramBytes() const {
  int64_t bytes = 0;
  for (const LayerProgram& program : programs) bytes += std::ssize(program.gcode);
  return bytes;
}

int64_t LaserResult::ProgramBytes() const {
  int64_t bytes = 0;
  for (const ExposedProgram& program : programs) bytes += std::ssize(program.text);
  return bytes;
}

size_t FdmResult::Print() const {
  size_t print = programs.size();
  for (const LayerProgram& program : programs)
    print = absl::HashOf(print, program.frame.index, program.pass, program.gcode, program.code_at,
                         program.stats.TimeS(), program.stats.FilamentMm());
  return print;
}

size_t LaserResult::Print() const {
  size_t print = programs.size();
  for (const ExposedProgram& program : programs)
    print = absl::HashOf(print, program.frame.index, program.text, program.report.TimeS());
  return print;
}

ProcessSet ProcessRunners::processes() const {
  ProcessSet all;
  for (const ProcessInfo& info : kProcesses)
    for (const TaskRunner* runner : runners_)
      if (runner->processes().Has(info.process)) all.Add(info.process);
  return all;
}

absl::StatusOr<TaskResult> ProcessRunners::RunTask(const StageCall& call, const Task& task) const {
  for (const TaskRunner* runner : runners_)
    if (runner->processes().Has(ProcessOf(task))) return runner->RunTask(call, task);
  return MakeError(
      absl::StatusCode::kInternal, Reason::kInternal,
      "no jobs of process " + std::string(ProcessName(ProcessOf(task))) + " are made here");
}

}  // namespace slicefarm
