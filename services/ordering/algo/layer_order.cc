#include "services/ordering/algo/layer_order.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/layers/region_check.h"
#include "common/model/options/ordering_options.h"
#include "services/ordering/algo/comb/bed_travels.h"
#include "services/ordering/algo/comb/copy_travels.h"
#include "services/ordering/algo/section_order.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {
namespace {

/// Number of lines of sight that may be computed between copies, to find detours around curled
/// areas.
constexpr int64_t kSightsOfCopies = 50'000;

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

/// Returns the plan of the stack. If the stack has none, returns a plan with the entry and curled
/// areas of its object's part.
SectionPlan PlanOf(const Stack& stack, const LayerPlan& plan) {
  if (const SectionPlan* own = FindPlan(stack.id, plan.sections); own != nullptr) return *own;
  const SectionPlan* part = FindPlan(stack.object, plan.sections);
  SectionPlan none;
  if (part != nullptr) {
    none.entry = part->entry;
    none.curled = part->curled;
  }
  return none;
}

/// Returns the sort key of blocks: first the plate's stacks, then by object, kind and stack id.
/// Copies are ordered later.
std::tuple<int32_t, StackKind, int32_t> OrderOf(const Stack& stack) {
  return {stack.object, stack.kind, stack.id};
}

/// Indices of the blocks of one object, in the order of printing.
using ObjectBlocks = std::vector<int32_t>;

std::map<int32_t, ObjectBlocks> BlocksByObject(const std::vector<PathBlock>& blocks) {
  std::map<int32_t, ObjectBlocks> by_object;
  for (size_t i = 0; i < blocks.size(); ++i)
    by_object[blocks[i].stack.object].push_back(static_cast<int32_t>(i));
  return by_object;
}

/// A copy and its blocks in one layer.
struct CopyVisit {
  const ObjectBlocks* blocks = nullptr;
  int32_t copy = 0;
  int32_t pass = 0;
  Point shift;
};

/// Orders the visits of one layer.
class LayerVisits {
 public:
  /// `as_listed`: true to visit the copies in their order on the plate.
  LayerVisits(OrderedLayer& layer, std::span<const Copy> copies, bool as_listed)
      : layer_(layer),
        copies_(copies),
        as_listed_(as_listed),
        by_object_(BlocksByObject(layer.blocks)) {}

  void Add(Point entry, WorkBudget& budget) {
    Point at = entry;
    if (const auto plate = by_object_.find(kPlateObject); plate != by_object_.end()) {
      Append({&plate->second, -1, 0, {}});
      at = EndOf(LastOf(plate->second).paths.back());
    }
    for (const auto& [pass, visits] : VisitsByPass())
      for (const CopyVisit& visit : Ordered(visits, at, budget)) Append(visit);
  }

 private:
  const PathBlock& FirstOf(const ObjectBlocks& blocks) const {
    return layer_.blocks[static_cast<size_t>(blocks.front())];
  }
  const PathBlock& LastOf(const ObjectBlocks& blocks) const {
    return layer_.blocks[static_cast<size_t>(blocks.back())];
  }

  void Append(const CopyVisit& visit) {
    for (const int32_t block : *visit.blocks)
      layer_.visits.push_back({block, visit.copy, visit.pass, visit.shift});
  }

  /// Returns the copies that have blocks in this layer, by pass.
  std::map<int32_t, std::vector<CopyVisit>> VisitsByPass() const {
    std::map<int32_t, std::vector<CopyVisit>> visits;
    for (size_t i = 0; i < copies_.size(); ++i) {
      const Copy& copy = copies_[i];
      if (const auto found = by_object_.find(copy.object); found != by_object_.end())
        visits[copy.pass].push_back(
            {&found->second, static_cast<int32_t>(i), copy.pass, copy.shift});
    }
    return visits;
  }

  /// Returns the visits in an order with little travel, beginning at `from`.
  std::vector<CopyVisit> Ordered(const std::vector<CopyVisit>& visits, Point from,
                                 WorkBudget& budget) const {
    if (as_listed_) return visits;
    std::vector<TourLeg> legs;
    for (const CopyVisit& visit : visits)
      legs.push_back({visit.shift + StartOf(FirstOf(*visit.blocks).paths.front()),
                      visit.shift + EndOf(LastOf(*visit.blocks).paths.back()), false});
    std::vector<CopyVisit> ordered;
    for (const Visit& visit : OrderByTravel({from, {}}, legs, budget))
      ordered.push_back(visits[visit.leg]);
    return ordered;
  }

  OrderedLayer& layer_;
  const std::span<const Copy> copies_;
  const bool as_listed_;
  const std::map<int32_t, ObjectBlocks> by_object_;
};

/// Returns true if the layer is a turn of a spiral. A spiral continues without a break at layer
/// changes.
bool IsTurn(const LayerPlan& plan) {
  return std::ranges::any_of(plan.sections,
                             [](const SectionPlan& section) { return section.spiral.has_value(); });
}

/// Returns the point where a section starts. The second and further stacks of an object start at
/// the end of the stack before; so do the stacks of the plate. The first stack of a single copy
/// starts at the nozzle's position.
Point EntryOf(const Stack& stack, const OrderedLayer& layer, const LayerPlan& plan,
              std::span<const Copy> copies) {
  const Point from = layer.blocks.empty() ? plan.entry : EndOf(layer.blocks.back().paths.back());
  if (stack.object == kPlateObject) return from;
  if (!layer.blocks.empty() && layer.blocks.back().stack.object == stack.object) return from;
  if (stack.IsPart() && layer.begins_ready) return plan.entry - copies.front().shift;
  if (!stack.IsPart() && copies.size() == 1) return from - copies.front().shift;
  return PlanOf(stack, plan).entry;
}

}  // namespace

absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        std::span<const Copy> copies,
                                        const OrderingOptions& options) {
  if (absl::Status ok = CheckPaths(layer, plan, options.walls.size()); !ok.ok()) return ok;
  std::ranges::sort(layer.sections, {},
                    [](const FilledSection& section) { return OrderOf(section.stack); });
  const bool may_be_ready =
      options.travel.hide && !options.travel.retract_layer_change && copies.size() == 1;
  OrderedLayer ordered{.frame = layer.frame,
                       .blocks = {},
                       .visits = {},
                       .begins_ready = plan.begins_ready && (may_be_ready || IsTurn(plan)),
                       .ends_ready = plan.ends_ready && (may_be_ready || IsTurn(plan))};
  if (!plan.paths.empty())
    ordered.blocks.push_back(
        {kSkirtStack,
         layer.frame.index,
         plan.paths_height_nm > 0 ? plan.paths_height_nm : layer.frame.height_nm,
         plan.paths,
         {}});
  for (FilledSection& section : layer.sections) {
    WorkBudget budget{options.improvement_moves};
    SectionPlan section_plan = PlanOf(section.stack, plan);
    section_plan.entry = EntryOf(section.stack, ordered, plan, copies);
    if (!ordered.ends_ready) section_plan.exit.reset();
    PathBlock block = OrderSection(std::move(section), section_plan, options, budget);
    if (!block.paths.empty()) ordered.blocks.push_back(std::move(block));
  }
  WorkBudget budget{options.improvement_moves};
  LayerVisits(ordered, copies, options.as_listed).Add(plan.entry, budget);
  WorkBudget sights{kSightsOfCopies};
  if (options.travel.avoid_curled) KeepOffCurled(plan, sights, ordered);
  KeepInTravelArea(options.travel.travel_area, ordered);
  return ordered;
}

}  // namespace slicefarm::ordering
