#include "services/milling/algo/motion/mill_program.h"

#include "services/milling/algo/motion/cut_order.h"
#include "services/milling/algo/motion/mill_clock.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/motion/rest_cutter.h"
#include "services/milling/algo/motion/stock_cutter.h"

namespace slicefarm::milling {
namespace {

absl::StatusOr<int> CutLevels(const MillingJob& job, std::span<const MilledStep> levels,
                              MoveBuilder& moves, const CancelToken& cancel) {
  StockCutter cutter(job.options, moves, cancel);
  int cut = 0;
  for (const AreaIndex& index : CutOrder(levels)) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const MilledStep& level = levels[index.level];
    cut += cutter.Cut(level.areas[index.area], level.step.at_mm, level.step.phase);
  }
  if (absl::Status status = cancel.Check(); !status.ok()) return status;
  return cut;
}

}  // namespace

absl::StatusOr<MillProgram> AssembleProgram(const MillingJob& job,
                                            std::span<const MilledStep> steps,
                                            const CancelToken& cancel) {
  MoveBuilder moves(job, cancel);
  MillProgram program{.moves = {}, .safe_z_mm = moves.safe_z_mm()};
  for (size_t first = 0, last = 0; first < steps.size(); first = last) {
    const MillPhase phase = steps[first].step.phase;
    while (last < steps.size() && steps[last].step.phase == phase) ++last;
    const auto of_phase = steps.subspan(first, last - first);
    moves.SetPhase(phase);
    const auto cut = phase == MillPhase::kRest ? CutRest(job, of_phase, moves, cancel)
                                               : CutLevels(job, of_phase, moves, cancel);
    if (!cut.ok()) return cut.status();
    program.passes += *cut;
  }
  moves.Retract();
  program.removed_mm3 = moves.stock().removed_mm3();
  program.moves = moves.TakeMoves();
  if (job.options.machining.corner_feeds) LowerFeeds(job.options, program.moves, cancel);
  if (absl::Status status = cancel.Check(); !status.ok()) return status;
  return program;
}

}  // namespace slicefarm::milling
