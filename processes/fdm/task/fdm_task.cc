#include "processes/fdm/task/fdm_task.h"

#include "absl/hash/hash.h"

namespace slicefarm {

int64_t FdmResult::ProgramBytes() const {
  int64_t bytes = 0;
  for (const LayerProgram& program : programs) bytes += std::ssize(program.gcode);
  return bytes;
}

size_t FdmResult::Print() const {
  size_t print = programs.size();
  for (const LayerProgram& program : programs)
    print = absl::HashOf(print, program.frame.index, program.pass, program.gcode, program.code_at,
                         program.stats.TimeS(), program.stats.FilamentMm());
  return print;
}

}  // namespace slicefarm
