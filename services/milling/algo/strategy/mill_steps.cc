#include "services/milling/algo/strategy/mill_steps.h"

#include <atomic>
#include <span>
#include <utility>

#include "common/base/parallel.h"

namespace slicefarm::milling {
namespace {

/// Steps of one stage, next to each other.
using StageSteps = std::span<MilledStep>;

std::vector<double> PlacesOf(StageSteps steps) {
  std::vector<double> places;
  for (const MilledStep& milled : steps) places.push_back(milled.step.at_mm);
  return places;
}

absl::Status MillLevels(const MillingJob& job, StageSteps steps, const CancelToken& cancel) {
  const bool roughing = steps[0].step.stage == MillingStage::kRoughing;
  const double allowance = roughing ? job.options.allowance_mm : 0;
  const auto levels = FreeAreas(job, allowance, PlacesOf(steps), cancel);
  if (!levels.ok()) return levels.status();
  std::atomic<bool> cancelled = false;
  ForEachIndex(job.options.threads, steps.size(), [&](size_t i, int) {
    if (cancelled || cancel.Cancelled()) {
      cancelled = true;
      return;
    }
    steps[i].areas = roughing ? RoughingWays((*levels)[i], job.options)
                              : FinishingWays((*levels)[i], job.options);
  });
  return cancelled ? cancel.Check() : absl::OkStatus();
}

absl::Status MillRows(const MillingJob& job, StageSteps steps, const CancelToken& cancel) {
  auto rows = RestRows(job, PlacesOf(steps), cancel);
  if (!rows.ok()) return rows.status();
  for (size_t i = 0; i < steps.size(); ++i) steps[i].runs = std::move((*rows)[i]);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<MilledStep>> MillSteps(const MillingJob& job, size_t first, size_t last,
                                                  const CancelToken& cancel) {
  std::vector<MilledStep> milled;
  for (size_t i = first; i < last; ++i) milled.push_back({job.steps[i], {}, {}});
  for (size_t from = 0, to = 0; from < milled.size(); from = to) {
    while (to < milled.size() && milled[to].step.stage == milled[from].step.stage) ++to;
    const StageSteps steps(&milled[from], to - from);
    const bool rows = milled[from].step.stage == MillingStage::kRest;
    const absl::Status status =
        rows ? MillRows(job, steps, cancel) : MillLevels(job, steps, cancel);
    if (!status.ok()) return status;
  }
  return milled;
}

}  // namespace slicefarm::milling
