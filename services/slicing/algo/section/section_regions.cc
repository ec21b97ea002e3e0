#include "services/slicing/algo/section/section_regions.h"

#include <cstdlib>
#include <iterator>
#include <utility>

#include "common/geometry/offset/offset.h"

namespace slicefarm::slicing {
namespace {

using Areas = std::map<int32_t, MultiPolygon>;  // areas per row of the settings

void Append(const MultiPolygon& from, MultiPolygon& to) {
  to.insert(to.end(), from.begin(), from.end());
}

MultiPolygon United(const MultiPolygon& areas) { return Union(Rings(areas), FillRule::kNonZero); }

/// Returns the areas of solid parts, indexed by their region settings. Where parts overlap, the
/// later part gets the area.
Areas SolidAreas(const std::vector<PartSection>& parts) {
  Areas areas;
  for (const PartSection& part : parts) {
    if (part.role != PartRole::kSolid || part.outlines.empty()) continue;
    for (auto& [row, area] : areas)
      if (row != part.settings) area = Difference(area, part.outlines);
    MultiPolygon& own = areas[part.settings];
    if (own.empty()) {
      own = part.outlines;
    } else {
      Append(part.outlines, own);
      own = United(own);
    }
  }
  return areas;
}

void CutOut(const MultiPolygon& hole, Areas& areas) {
  for (auto& [row, area] : areas) area = Difference(area, hole);
}

/// Moves the areas inside a modifier to the region settings that the modifier defines.
void Modify(const PartSection& modifier, Areas& areas) {
  Areas changed;
  for (auto& [row, area] : areas) {
    const auto change = modifier.changes->find(row);
    if (change == modifier.changes->end() || change->second == row) {
      Append(area, changed[row]);
      continue;
    }
    Append(Intersection(area, modifier.outlines), changed[change->second]);
    Append(Difference(area, modifier.outlines), changed[row]);
  }
  for (auto& [row, area] : changed) area = United(area);
  areas = std::move(changed);
}

/// Fits the areas to the whole after the edits have moved the outlines of the whole. Areas grow by
/// up to `reach_nm` and are cut to the whole. Parts of the whole that no area covers are added to
/// the first area.
void FitInto(const MultiPolygon& whole, Coord reach_nm, Areas& areas) {
  MultiPolygon left = whole;
  for (auto& [row, area] : areas) {
    area = Intersection(reach_nm > 0 ? Offset(area, reach_nm) : area, left);
    if (!area.empty()) left = Difference(left, area);
  }
  if (left.empty()) return;
  auto& first = areas.begin()->second;
  Append(left, first);
  first = United(first);
}

/// Returns the united sections of all parts with a role.
MultiPolygon AllOf(PartRole role, const std::vector<PartSection>& parts) {
  MultiPolygon all;
  for (const PartSection& part : parts)
    if (part.role == role) Append(part.outlines, all);
  return all.empty() ? all : United(all);
}

bool IsOneSolid(const std::vector<PartSection>& parts) {
  return parts.size() == 1 && parts[0].role == PartRole::kSolid;
}

PartitionedSection AsRegions(Areas areas, MultiPolygon whole) {
  PartitionedSection section;
  for (auto& [row, area] : areas)
    if (!area.empty()) section.regions.push_back({Role::kPart, row, 0, std::move(area)});
  if (section.regions.size() > 1) section.whole = std::move(whole);
  return section;
}

}  // namespace

PartitionedSection Partition(std::vector<PartSection> parts, const RegionEdits& edits,
                             Coord resolution_nm) {
  if (IsOneSolid(parts)) {
    Areas areas;
    areas[parts[0].settings] = Edited(std::move(parts[0].outlines), edits, resolution_nm);
    return AsRegions(std::move(areas), {});
  }
  Areas areas = SolidAreas(parts);
  for (const PartSection& part : parts)
    if (part.role == PartRole::kNegative && !part.outlines.empty()) CutOut(part.outlines, areas);
  MultiPolygon whole;
  for (const auto& [row, area] : areas) Append(area, whole);
  // A single region has no united whole: its outlines must keep the same points, not only the same
  // area.
  if (areas.size() > 1) whole = United(whole);
  whole = Edited(std::move(whole), edits, resolution_nm);
  for (const PartSection& part : parts)
    if (part.role == PartRole::kModifier && !part.outlines.empty()) Modify(part, areas);
  if (whole.empty()) return {};
  if (areas.size() == 1) {
    areas.begin()->second = whole;
  } else if (edits != RegionEdits{}) {
    const Coord reach =
        std::abs(edits.grow_nm) + std::abs(edits.widen_holes_nm) + 2 * edits.closing_radius_nm;
    FitInto(whole, reach, areas);
  }
  PartitionedSection section = AsRegions(std::move(areas), std::move(whole));
  for (const PartRole role : {PartRole::kSupportEnforcer, PartRole::kSupportBlocker,
                              PartRole::kSeamEnforcer, PartRole::kSeamBlocker}) {
    MultiPolygon marked = AllOf(role, parts);
    if (!marked.empty()) section.marks.push_back({role, std::move(marked)});
  }
  return section;
}

}  // namespace slicefarm::slicing
