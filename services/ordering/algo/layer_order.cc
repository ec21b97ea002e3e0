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

/// What lies on the plate besides the objects, in the order of printing: the plan's finished paths,
/// then the plate's sections. Returns where that ends.
Point VisitPlate(const LayerPlan& plan, OrderedLayer& layer) {
  Point at = plan.entry;
  for (size_t i = 0; i < layer.blocks.size() && layer.blocks[i].object == kPlate; ++i) {
    layer.visits.push_back({static_cast<int32_t>(i), -1, 0, {}});
    at = EndOf(layer.blocks[i].paths.back());
  }
  return at;
}

/// The copies that have something in this layer, by pass.
std::map<int32_t, std::vector<BlockVisit>> VisitsByPass(const std::vector<PathBlock>& blocks,
                                                        std::span<const Copy> copies) {
  std::map<int32_t, int32_t> block_of;  // by object
  for (size_t i = 0; i < blocks.size(); ++i)
    block_of[blocks[i].object] = static_cast<int32_t>(i);
  std::map<int32_t, std::vector<BlockVisit>> visits;
  for (size_t i = 0; i < copies.size(); ++i) {
    const Copy& copy = copies[i];
    if (const auto block = block_of.find(copy.object); block != block_of.end())
      visits[copy.pass].push_back(
          {block->second, static_cast<int32_t>(i), copy.pass, copy.shift});
  }
  return visits;
}

/// By travel from `from`.
std::vector<BlockVisit> Ordered(const std::vector<BlockVisit>& visits,
                                const std::vector<PathBlock>& blocks, Point from,
                                WorkBudget& budget) {
  std::vector<Leg> legs;
  for (const BlockVisit& visit : visits) {
    const std::vector<Path>& paths = blocks[static_cast<size_t>(visit.block)].paths;
    legs.push_back(
        {visit.shift + StartOf(paths.front()), visit.shift + EndOf(paths.back()), false});
  }
  std::vector<BlockVisit> ordered;
  for (const Visit& visit : OrderByTravel({from, {}}, legs, budget))
    ordered.push_back(visits[visit.leg]);
  return ordered;
}

void AddVisits(const LayerPlan& plan, std::span<const Copy> copies, WorkBudget& budget,
               OrderedLayer& layer) {
  const Point at = VisitPlate(plan, layer);
  for (const auto& [pass, visits] : VisitsByPass(layer.blocks, copies)) {
    const std::vector<BlockVisit> ordered = Ordered(visits, layer.blocks, at, budget);
    layer.visits.insert(layer.visits.end(), ordered.begin(), ordered.end());
  }
}

}  // namespace

absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        std::span<const Copy> copies,
                                        const OrderingOptions& options) {
  if (absl::Status ok = CheckPaths(layer, plan, options.walls.size()); !ok.ok()) return ok;
  std::ranges::stable_sort(layer.sections, {}, &FilledSection::object);
  const bool may_be_ready =
      options.travel.hide && !options.travel.retract_layer_change && copies.size() == 1;
  OrderedLayer ordered{.frame = layer.frame,
                       .blocks = {},
                       .visits = {},
                       .begins_ready = plan.begins_ready && may_be_ready,
                       .ends_ready = plan.ends_ready && may_be_ready};
  if (!plan.paths.empty())
    ordered.blocks.push_back({kPlate, layer.frame.index, layer.frame.height_nm, plan.paths, {}});
  for (FilledSection& section : layer.sections) {
    WorkBudget budget{options.improvement_moves};
    SectionPlan section_plan = PlanOf(section.object, plan);
    if (section.object == kPlate) {
      section_plan.entry =
          ordered.blocks.empty() ? plan.entry : EndOf(ordered.blocks.back().paths.back());
    } else if (ordered.begins_ready) {  // where the layer below has led
      section_plan.entry = plan.entry - copies.front().shift;
    }
    if (!ordered.ends_ready) section_plan.exit.reset();
    PathBlock block = OrderSection(std::move(section), section_plan, options, budget);
    if (!block.paths.empty()) ordered.blocks.push_back(std::move(block));
  }
  WorkBudget budget{options.improvement_moves};
  AddVisits(plan, copies, budget, ordered);
  return ordered;
}

}  // namespace slicefarm::ordering
