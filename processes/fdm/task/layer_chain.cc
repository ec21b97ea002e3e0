#include "processes/fdm/task/layer_chain.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "common/base/stopwatch.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/motion_job.h"
#include "common/stage/object_layers.h"
#include "common/stage/ordering_job.h"
#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm {

namespace {

/// Returns the neighbourhood with a halo of only `halo` layers, so that a remote stage does not
/// receive outlines that it does not use. REQUIRES: CheckHalo.
Neighbourhood Trimmed(const Neighbourhood& all, int32_t halo) {
  const int32_t sent_from = all.layers.front().frame.index;
  const LayerRange kept =
      WithHalo(all.layers, {all.range.first - sent_from, all.range.last - sent_from}, halo);
  return {all.range,
          all.layers.subspan(static_cast<size_t>(kept.first), static_cast<size_t>(kept.size()))};
}

/// Adds the outlines below to the blocks for which motion needs them: all blocks if motion looks
/// below, and turns of a spiral. Adds curled areas if motion slows down above them. `plans`: one
/// per layer.
void AddBelow(std::span<const SlicedLayer> sliced, std::span<const LayerPlan> plans,
              const MotionOptions& motion, std::vector<OrderedLayer>& ordered) {
  const bool looks = LooksBelow(motion);
  const ObjectLayers stacks(sliced);
  for (size_t i = 0; i < ordered.size(); ++i) {
    for (PathBlock& block : ordered[i].blocks) {
      if (!block.stack.IsPart() || block.layer == 0 || !(looks || block.spiral)) continue;
      if (const ObjectSection* below = stacks.Find(block.stack.id, block.layer - 1))
        block.below = OutlineOf(*below);
      const SectionPlan* plan = FindPlan(block.stack.id, plans[i].sections);
      if (plan == nullptr) continue;
      block.above_supports = plan->above_supports;
      if (motion.slow_curled) block.curled = plan->curled;
    }
  }
}

/// Adds the object's surface near the layer to the blocks of parts. The first layer lies level on
/// the bed.
void AddSurfaces(std::span<const SlicedLayer> sliced, std::vector<OrderedLayer>& ordered) {
  const auto has_surface = [](const SlicedLayer& layer) {
    return std::ranges::any_of(layer.sections, [](const auto& s) { return !s.surface.empty(); });
  };
  if (std::ranges::none_of(sliced, has_surface)) return;
  const ObjectLayers stacks(sliced);
  for (OrderedLayer& layer : ordered) {
    for (PathBlock& block : layer.blocks) {
      if (!block.stack.IsPart() || block.layer == 0) continue;
      const ObjectSection* section = stacks.Find(block.stack.id, block.layer);
      if (section != nullptr) block.surface = section->surface;
    }
  }
}

void NoteWarnings(const std::vector<WalledLayer>& layers, std::vector<LayerWarning>& warnings) {
  for (const WalledLayer& layer : layers) {
    if (layer.plain_islands == 0) continue;
    warnings.push_back({.layer = layer.frame.index, .plain_islands = layer.plain_islands});
  }
}

/// Moves the infill figures out of the layers and returns them, summed over all copies.
std::vector<FillStats> TakeUses(std::vector<FilledLayer>& layers, std::span<const Copy> copies) {
  std::map<int32_t, int64_t> count = {{kPlateObject, 1}};  // number of copies by object
  for (const Copy& copy : copies) ++count[copy.object];
  std::vector<FillStats> all;
  for (FilledLayer& layer : layers) {
    std::vector<FillStats> uses;
    for (FilledSection& section : layer.sections)
      for (const FillStats& use : std::exchange(section.uses, {}))
        AddUse(use, count[section.stack.object], uses);
    std::ranges::move(uses, std::back_inserter(all));
  }
  return all;
}

/// Job-wide inputs of each stage.
struct StageJobs {
  Shared<BeadingTable> beading;
  Shared<InfillTable> infill;
  Shared<OrderingJob> ordering;
  Shared<MotionJob> motion;
};

StageJobs StageJobsOf(const FdmShared& job) {
  return {BeadingOf(job.settings), InfillOf(job.settings),
          OrderingJob{OrderingOf(job.settings), job.copies},
          MotionJob{MotionOf(job.settings), job.facts}};
}

}  // namespace

std::shared_ptr<const LayerChain> LayerChain::Over(const Stages& stages) {
  if (stages.beading == nullptr || stages.infill == nullptr || stages.ordering == nullptr ||
      stages.motion == nullptr)
    return nullptr;
  return std::make_shared<LayerChain>(*stages.beading, *stages.infill, *stages.ordering,
                                      *stages.motion);
}

std::vector<Stage> LayerChain::StagesOf() {
  return {Stage::kBeading, Stage::kInfill, Stage::kOrdering, Stage::kMotion};
}

absl::StatusOr<FdmResult> LayerChain::Run(const StageCall& call, const FdmTask& task) const {
  FdmResult result;
  const Neighbourhood neighbourhood{task.range, task.layers};
  const FdmSettings& settings = task.job->settings;
  const StageJobs& jobs = task.job.Once(StageJobsOf);
  if (absl::Status ok = CheckHalo(task.layers, task.range, HaloLayers(settings)); !ok.ok())
    return ok;

  auto walled = Timed(result.times[Stage::kBeading], [&] {
    return beading_.Bead(call, Trimmed(neighbourhood, BeadingHaloLayers(settings)), jobs.beading);
  });
  if (!walled.ok()) return walled.status();
  NoteWarnings(*walled, result.warnings);
  auto filled = Timed(result.times[Stage::kInfill], [&] {
    return infill_.Fill(call, *std::move(walled), neighbourhood, task.plans, jobs.infill);
  });
  if (!filled.ok()) return filled.status();
  result.fills = TakeUses(*filled, task.job->copies);
  auto ordered = Timed(result.times[Stage::kOrdering], [&] {
    return ordering_.Order(call, *std::move(filled), task.plans, jobs.ordering);
  });
  if (!ordered.ok()) return ordered.status();
  AddBelow(task.layers, task.plans, jobs.motion->options, *ordered);
  AddSurfaces(task.layers, *ordered);
  auto programs = Timed(result.times[Stage::kMotion],
                        [&] { return motion_.Program(call, *std::move(ordered), jobs.motion); });
  if (!programs.ok()) return programs.status();
  result.programs = *std::move(programs);
  return result;
}

}  // namespace slicefarm
