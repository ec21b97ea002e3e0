#include "services/milling/algo/strategy/mill_steps.h"

#include <atomic>
#include <span>
#include <utility>

#include "common/base/parallel.h"

namespace slicefarm::milling {
namespace {

/// Consecutive steps of one phase.
using PhaseSteps = std::span<MilledStep>;

std::vector<double> PositionsOf(PhaseSteps steps) {
  std::vector<double> positions;
  for (const MilledStep& milled : steps) positions.push_back(milled.step.at_mm);
  return positions;
}

absl::Status MillLevels(const MillingJob& job, PhaseSteps steps, const CancelToken& cancel,
                        int threads) {
  const bool roughing = steps[0].step.phase == MillPhase::kRoughing;
  const double allowance = roughing ? job.options.allowance_mm : 0;
  const auto levels = FreeAreas(job, allowance, PositionsOf(steps), cancel, threads);
  if (!levels.ok()) return levels.status();
  std::atomic<bool> cancelled = false;
  ForEachIndex(threads, steps.size(), [&](size_t i, int) {
    if (cancelled || cancel.Cancelled()) {
      cancelled = true;
      return;
    }
    steps[i].areas = roughing ? RoughingPasses((*levels)[i], job.options, cancel)
                              : FinishingPasses((*levels)[i], job.options);
  });
  return cancel.Check();
}

absl::Status MillRows(const MillingJob& job, PhaseSteps steps, const CancelToken& cancel,
                      int threads) {
  auto rows = RestRows(job, PositionsOf(steps), cancel, threads);
  if (!rows.ok()) return rows.status();
  for (size_t i = 0; i < steps.size(); ++i) steps[i].runs = std::move((*rows)[i]);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<MilledStep>> MillSteps(const MillingJob& job, size_t first, size_t last,
                                                  const CancelToken& cancel, int threads) {
  std::vector<MilledStep> milled;
  for (size_t i = first; i < last; ++i) milled.push_back({job.steps[i], {}, {}});
  for (size_t from = 0, to = 0; from < milled.size(); from = to) {
    while (to < milled.size() && milled[to].step.phase == milled[from].step.phase) ++to;
    const PhaseSteps steps(&milled[from], to - from);
    const bool rows = milled[from].step.phase == MillPhase::kRest;
    const absl::Status status =
        rows ? MillRows(job, steps, cancel, threads) : MillLevels(job, steps, cancel, threads);
    if (!status.ok()) return status;
  }
  return milled;
}

}  // namespace slicefarm::milling
