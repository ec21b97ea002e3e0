#include "processes/laser/task/laser_task.h"

#include "absl/hash/hash.h"

namespace slicefarm {

int64_t LaserResult::ProgramBytes() const {
  int64_t bytes = 0;
  for (const ExposedProgram& program : programs) bytes += std::ssize(program.text);
  return bytes;
}

size_t LaserResult::Print() const {
  size_t print = programs.size();
  for (const ExposedProgram& program : programs)
    print = absl::HashOf(print, program.frame.index, program.text, program.report.TimeS());
  return print;
}

}  // namespace slicefarm
