#include "services/milling/algo/motion/mill_program.h"

#include "services/milling/algo/motion/cut_order.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/motion/rest_cutter.h"
#include "services/milling/algo/motion/way_cutter.h"

namespace slicefarm::milling {
namespace {

absl::StatusOr<int> CutLevels(const MillingJob& job, std::span<const MilledStep> levels,
                              MoveBuilder& moves, const CancelToken& cancel) {
  WayCutter cutter(job.options, moves);
  int cut = 0;
  for (const AreaPlace& place : CutOrder(levels)) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const MilledStep& level = levels[place.level];
    cut += cutter.Cut(level.areas[place.area], level.step.at_mm, level.step.stage);
  }
  return cut;
}

}  // namespace

absl::StatusOr<MillProgram> AssembleProgram(const MillingJob& job,
                                            std::span<const MilledStep> steps,
                                            const CancelToken& cancel) {
  MoveBuilder moves(job);
  MillProgram program{.moves = {}, .safe_z_mm = moves.safe_z_mm()};
  for (size_t first = 0, last = 0; first < steps.size(); first = last) {
    const MillingStage stage = steps[first].step.stage;
    while (last < steps.size() && steps[last].step.stage == stage) ++last;
    const auto of_stage = steps.subspan(first, last - first);
    moves.SetStage(stage);
    const auto cut = stage == MillingStage::kRest ? CutRest(job, of_stage, moves, cancel)
                                                  : CutLevels(job, of_stage, moves, cancel);
    if (!cut.ok()) return cut.status();
    program.ways += *cut;
  }
  moves.Retract();
  program.removed_mm3 = moves.stock().removed_mm3();
  program.moves = moves.TakeMoves();
  return program;
}

}  // namespace slicefarm::milling
