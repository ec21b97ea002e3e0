#include "services/planning/algo/supports/planner/supports_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/planner/planner.h"
#include "services/planning/algo/supports/generator/support_planner.h"
#include "services/planning/algo/supports/planner/plate_solids.h"

namespace slicefarm::planning {
namespace {

/// Number of findings per object that are reported individually.
constexpr size_t kReportedFindings = 5;

SupportRow RowOf(const SupportLayer& layer, SupportRole role) {
  switch (role) {
    case SupportRole::kTopInterface:
      return SupportRow::kInterface;
    case SupportRole::kBottomInterface:
      return SupportRow::kBottomInterface;
    case SupportRole::kBase:
      return layer.first ? SupportRow::kFirstLayer : SupportRow::kBase;
    case SupportRole::kBranch:
      return layer.first ? SupportRow::kFirstLayer : SupportRow::kBranch;
    case SupportRole::kThickBranch:
      return layer.first ? SupportRow::kFirstLayer : SupportRow::kThickBranch;
  }
  return SupportRow::kBase;
}

/// Adds outlines to the region with the same row and role, or adds a new region.
void AddRegion(Role role, int32_t row, MultiPolygon outlines, std::vector<Region>& regions) {
  const auto same = std::ranges::find_if(
      regions, [&](const Region& region) { return region.role == role && region.settings == row; });
  if (same == regions.end()) {
    regions.push_back({role, row, 0, std::move(outlines)});
  } else {
    same->outlines = Union(same->outlines, outlines);
  }
}

ObjectSection SectionOf(SupportLayer layer, const Stack& stack, const SupportRows& rows) {
  ObjectSection section;
  section.stack = stack;
  section.height_nm = layer.height_nm;
  section.z_nm = layer.top_nm;
  for (SupportRegion& region : layer.regions) {
    const SupportRow row = RowOf(layer, region.role);
    const bool dense = row == SupportRow::kInterface || row == SupportRow::kBottomInterface;
    const Role role = dense ? Role::kSupportInterface : Role::kSupport;
    AddRegion(role, rows[static_cast<size_t>(row)], std::move(region.outlines), section.regions);
  }
  if (section.regions.size() <= 1) return section;
  for (const Region& region : section.regions)
    section.whole = section.whole.empty() ? region.outlines : Union(section.whole, region.outlines);
  return section;
}

std::string TextOf(const SupportFinding& finding) {
  const std::string what =
      finding.kind == SupportFinding::Kind::kStartsInAir
          ? (finding.above_supports ? "starts in the air, on a support" : "starts in the air")
          : "cannot be supported";
  return fmt::format("{:.2f} mm2 at ({:.1f}, {:.1f}), {:.2f} mm above its bottom: {}",
                     finding.area_mm2, ToMm(finding.place.x), ToMm(finding.place.y),
                     ToMm(finding.bottom_nm), what);
}

/// Adds warnings for the user. Places are in the object's own coordinates.
void AddWarnings(const std::string& name, std::vector<SupportFinding> findings,
                 std::vector<std::string>& warnings) {
  std::erase_if(findings, [](const SupportFinding& finding) { return finding.above_supports; });
  std::ranges::stable_sort(findings, std::ranges::greater{}, &SupportFinding::area_mm2);
  for (size_t i = 0; i < std::min(findings.size(), kReportedFindings); ++i)
    warnings.push_back(fmt::format("{}: {}", name, TextOf(findings[i])));
  if (findings.size() > kReportedFindings)
    warnings.push_back(
        fmt::format("{}: {} more unsupported areas", name, findings.size() - kReportedFindings));
}

}  // namespace

bool SupportsPlanner::IsNeeded(const PlanningOptions& options, std::span<const PlacedCopy> copies) {
  return std::ranges::any_of(copies, [&](const PlacedCopy& copy) {
    return options.objects[static_cast<size_t>(copy.object)].support.on;
  });
}

absl::Status SupportsPlanner::Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                                   RegionPlan& plan) {
  std::set<int32_t> objects;
  for (const PlacedCopy& copy : copies_)
    if (options_.objects[static_cast<size_t>(copy.object)].support.on) objects.insert(copy.object);
  PlateSolids plate(parts, copies_);
  std::vector<AddedStack> done;
  done.reserve(objects.size());  // the plate keeps pointers to the elements
  for (const int32_t object : objects) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    const ObjectPlanOptions& options = options_.objects[static_cast<size_t>(object)];
    SupportProblem problem = plate.ProblemOf(object, options_.bed, kClearanceNm);
    // A raft has its own expansion below the supports that rest on it.
    if (options.raft.heights.layers == 0)
      problem.first_layer_expansion_nm = options.raft.first_layer_expansion_nm;
    auto planned = PlanSupports(problem, options.support, threads_, cancel);
    if (!planned.ok()) return planned.status();
    AddWarnings(NameOf(object, object_names_), std::move(planned->findings), plan.warnings);
    for (size_t i = 0; i < planned->above_supports.size(); ++i)
      if (!planned->above_supports[i].empty())
        plan.above_supports[{object, static_cast<int32_t>(i)}] =
            std::move(planned->above_supports[i]);
    if (planned->layers.empty()) continue;
    AddedStack& added = done.emplace_back();
    added.stack = plan.Add(object, StackKind::kSupport).stack;
    for (SupportLayer& layer : planned->layers)
      added.sections.push_back(SectionOf(std::move(layer), added.stack, options.support_settings));
    for (size_t i = 0; i < added.sections.size(); ++i) {
      added.sections[i].layer = static_cast<int32_t>(i);
      added.sections[i].layer_count = static_cast<int32_t>(added.sections.size());
    }
    plate.Add(added);
  }
  for (AddedStack& added : done) {
    const auto place = std::ranges::find(plan.stacks, added.stack, &AddedStack::stack);
    place->sections = std::move(added.sections);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
