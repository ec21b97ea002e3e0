#include "services/ordering/algo/layer_order.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/region_check.h"
#include "services/ordering/algo/section_order.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {
namespace {

template <typename Visitor>
void ForEachPath(const FilledLayer& layer, const LayerPlan& plan, const Visitor& visit) {
  for (const FilledSection& section : layer.sections) {
    for (const FilledIsland& island : section.islands) {
      for (const Path& wall : island.walls) visit(wall);
      for (const FillGroup& group : island.fills)
        for (const Path& path : group.paths) visit(path);
    }
  }
  for (const Path& path : plan.paths) visit(path);
}

absl::Status CheckPaths(const FilledLayer& layer, const LayerPlan& plan, size_t rows) {
  size_t bad = 0;
  absl::Status regions;
  ForEachPath(layer, plan, [&](const Path& path) {
    bad += WellFormed(path) ? 0 : 1;
    if (regions.ok()) regions = CheckRegion(path.settings, path.tool, rows, layer.frame);
  });
  if (bad == 0) return regions;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   absl::StrCat("layer ", layer.frame.index, ": ", bad,
                                " paths with fewer than 2 points or a wrong number of widths"),
                   {{"layer", std::to_string(layer.frame.index)}});
}

const SectionPlan& PlanOf(int32_t object, const LayerPlan& plan) {
  static const SectionPlan kNone;
  const auto found = std::ranges::lower_bound(plan.sections, object, {}, &SectionPlan::object);
  return found != plan.sections.end() && found->object == object ? *found : kNone;
}

/// The finished paths of the plan, before the plate's section if there is one.
void AddFinished(const LayerPlan& plan, const LayerFrame& frame, std::vector<PathBlock>& blocks) {
  if (plan.paths.empty()) return;
  if (blocks.empty() || blocks.front().object != kPlate)
    blocks.insert(blocks.begin(), {kPlate, frame.index, frame.height_nm, {}});
  std::vector<Path>& paths = blocks.front().paths;
  paths.insert(paths.begin(), plan.paths.begin(), plan.paths.end());
}

/// The copies of a pass that have something in this layer, by travel from `from`.
std::vector<BlockVisit> VisitsOf(int32_t pass, const std::vector<PathBlock>& blocks,
                                 std::span<const Copy> copies, Point from, WorkBudget& budget) {
  std::map<int32_t, int32_t> block_of;  // by object
  for (size_t i = 0; i < blocks.size(); ++i)
    block_of[blocks[i].object] = static_cast<int32_t>(i);
  std::vector<BlockVisit> visits;
  std::vector<Leg> legs;
  for (size_t i = 0; i < copies.size(); ++i) {
    const auto block = block_of.find(copies[i].object);
    if (copies[i].pass != pass || block == block_of.end()) continue;
    const std::vector<Path>& paths = blocks[static_cast<size_t>(block->second)].paths;
    visits.push_back({block->second, static_cast<int32_t>(i), pass, copies[i].shift});
    legs.push_back({copies[i].shift + StartOf(paths.front()),
                    copies[i].shift + EndOf(paths.back()), false});
  }
  std::vector<BlockVisit> ordered;
  for (const Visit& visit : OrderByTravel({from, {}}, legs, budget))
    ordered.push_back(visits[visit.leg]);
  return ordered;
}

std::vector<int32_t> PassesOf(std::span<const Copy> copies) {
  std::vector<int32_t> passes;
  for (const Copy& copy : copies) passes.push_back(copy.pass);
  std::ranges::sort(passes);
  passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
  return passes;
}

void AddVisits(const LayerPlan& plan, std::span<const Copy> copies, WorkBudget& budget,
               OrderedLayer& layer) {
  Point at = plan.entry;
  if (!layer.blocks.empty() && layer.blocks.front().object == kPlate) {
    layer.visits.push_back({});
    at = EndOf(layer.blocks.front().paths.back());
  }
  for (const int32_t pass : PassesOf(copies)) {
    const std::vector<BlockVisit> visits = VisitsOf(pass, layer.blocks, copies, at, budget);
    layer.visits.insert(layer.visits.end(), visits.begin(), visits.end());
  }
}

}  // namespace

absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        std::span<const Copy> copies,
                                        const OrderingOptions& options) {
  if (absl::Status ok = CheckPaths(layer, plan, options.walls.size()); !ok.ok()) return ok;
  std::ranges::stable_sort(layer.sections, {}, &FilledSection::object);
  OrderedLayer ordered{layer.frame, {}, {}};
  for (FilledSection& section : layer.sections) {
    WorkBudget budget{options.improvement_moves};
    PathBlock block{section.object, section.layer, section.height_nm, {}};
    const SectionPlan& section_plan = PlanOf(block.object, plan);
    block.paths = OrderSection(std::move(section), section_plan, options, budget);
    if (!block.paths.empty()) ordered.blocks.push_back(std::move(block));
  }
  AddFinished(plan, layer.frame, ordered.blocks);
  WorkBudget budget{options.improvement_moves};
  AddVisits(plan, copies, budget, ordered);
  return ordered;
}

}  // namespace slicefarm::ordering
