#include "processes/mill/task/mill_task.h"

#include "absl/hash/hash.h"
#include "absl/strings/str_cat.h"

namespace slicefarm {
namespace {

/// Approximate number of bytes of a point in a program, which has a word for each changed
/// coordinate.
constexpr int64_t kBytesAPoint = 20;

const char* WordsOf(MillPhase phase) {
  switch (phase) {
    case MillPhase::kRoughing:
      return "roughing level";
    case MillPhase::kFinishing:
      return "finishing level";
    case MillPhase::kRest:
      return "rest row";
  }
  return "";
}

size_t PrintOf(const Polygon& ring, size_t print) {
  for (const Point p : ring) print = absl::HashOf(print, p.x, p.y);
  return print;
}

}  // namespace

TaskLabel MillTask::Label() const {
  const int32_t last = phase_first + steps.size() - 1;
  TaskLabel label;
  label.text = steps.size() == 1 ? absl::StrCat(WordsOf(phase), " ", phase_first)
                                 : absl::StrCat(WordsOf(phase), "s ", phase_first, " to ", last);
  label.numbers = {{"step_first", steps.first}, {"step_last", steps.last - 1}};
  return label;
}

size_t MillResult::Print() const {
  size_t print = steps.size();
  for (const MilledStep& step : steps) {
    print = absl::HashOf(print, static_cast<int>(step.step.phase), step.step.at_mm);
    for (const CutArea& area : step.areas) {
      print = PrintOf(area.area.outer, print);
      for (const Polygon& hole : area.area.holes) print = PrintOf(hole, print);
      for (const Polygon& path : area.passes) print = PrintOf(path, print);
    }
    for (const RestRun& run : step.runs)
      for (const Eigen::Vector3d& p : run) print = absl::HashOf(print, p.x(), p.y(), p.z());
  }
  return print;
}

int64_t MillResult::ProgramBytes() const {
  int64_t points = 0;
  for (const MilledStep& step : steps) {
    for (const CutArea& area : step.areas)
      for (const Polygon& path : area.passes) points += std::ssize(path);
    for (const RestRun& run : step.runs) points += std::ssize(run);
  }
  return kBytesAPoint * points;
}

}  // namespace slicefarm
