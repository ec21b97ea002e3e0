#include "services/planning/algo/conflicts/conflict_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/conflicts/meeting.h"

namespace slicefarm::planning {
namespace {

/// Upper limit for the height of a section: for layer_height, and for the gap above a raft.
constexpr Coord kHighestSectionNm = 10 * kNmPerMm;

/// Returns the height above the bed below which an object may meet rafts and brims of the plate.
Coord LowHeight(const PlanningOptions& options) {
  Coord height_nm = 1;
  for (const ObjectPlanOptions& object : options.objects) {
    const RaftHeights& raft = object.raft.heights;
    if (raft.layers > 0) height_nm = std::max(height_nm, raft.TopOf(raft.layers - 1));
  }
  return height_nm;
}

/// Returns the area that the lines of loops cover.
MultiPolygon CoverOf(std::span<const Path> loops) {
  if (loops.empty()) return {};
  std::vector<Polyline> lines;
  for (const Path& loop : loops) {
    lines.push_back(loop.points);
    if (loop.closed) lines.back().push_back(loop.points.front());
  }
  return OffsetLines(lines, loops.front().widths_nm.front() / 2, Cap::kButt);
}

/// Returns the indices of two copies: one of `object`, and the one that has the object and the
/// relative position of `beside`.
std::pair<size_t, size_t> CopiesThat(int32_t object, const Beside& beside,
                                     std::span<const PlacedCopy> copies) {
  for (size_t i = 0; i < copies.size(); ++i)
    for (size_t j = 0; j < copies.size(); ++j)
      if (i != j && copies[i].object == object && copies[j].object == beside.object &&
          copies[j].shift - copies[i].shift == beside.shift)
        return {i, j};
  return {};
}

}  // namespace

ConflictPlanner::ConflictPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                                 std::span<const std::string> object_names)
    : options_(options),
      copies_(copies),
      object_names_(object_names),
      low_nm_(LowHeight(options)),
      near_(copies),
      skirt_reach_(options.skirt) {
  for (const PlacedCopy& copy : copies)
    if (!copy.footprint.empty())
      near_.Claim(copy.object, Bounds(Moved(copy.footprint, Point{} - copy.shift)));
}

ConflictPlanner::Slice ConflictPlanner::SliceOf(const ObjectSection& section, Coord top_nm) {
  const MultiPolygon& outline = OutlineOf(section);
  return {section.stack, top_nm - section.height_nm, top_nm, Bounds(outline), outline};
}

void ConflictPlanner::Look(const SlicedLayer& layer, LayerPlan& /*plan*/) {
  const bool in_skirt = skirt_reach_.Next(layer);
  if (!found_.ok()) return;
  const LayerFrame& frame = layer.frame;
  for (const ObjectSection& section : layer.sections)
    if (section.stack.object != kPlateObject && !OutlineOf(section).empty())
      near_.Claim(section.stack.object, Bounds(OutlineOf(section)));
  for (const ObjectSection& section : layer.sections) {
    const MultiPolygon& outline = OutlineOf(section);
    if (outline.empty()) continue;
    const int32_t object = section.stack.object;
    if (object != kPlateObject && in_skirt) AddToHull(object, outline);
    const bool low = frame.print_z_nm - section.height_nm < low_nm_;
    const bool near = object != kPlateObject && !near_.Of(object).empty();
    if (!low && !near) continue;
    const Slice slice = SliceOf(section, frame.print_z_nm);
    if (low) low_[object].push_back(slice);
    if (near) CompareAndKeep(slice);
  }
}

void ConflictPlanner::AddToHull(int32_t object, const MultiPolygon& outline) {
  Polygon& hull = hulls_[object];
  for (const PolygonWithHoles& island : outline)
    hull.insert(hull.end(), island.outer.begin(), island.outer.end());
  hull = ConvexHull(std::move(hull));
}

void ConflictPlanner::CompareAndKeep(const Slice& slice) {
  std::deque<Slice>& own = kept_[slice.stack.object];
  own.push_back(slice);
  while (own.front().top_nm <= slice.top_nm - kHighestSectionNm) own.pop_front();
  Compare(slice, kept_);
}

void ConflictPlanner::Compare(const Slice& slice, const Slices& kept) {
  for (const Beside& beside : near_.Of(slice.stack.object)) {
    const auto others = kept.find(beside.object);
    if (others == kept.end()) continue;
    for (const Slice& other : others->second) {
      if (!found_.ok() || !slice.SharesHeight(other)) continue;
      const Box box = {other.box.min + beside.shift, other.box.max + beside.shift};
      if (!slice.box.Intersects(box)) continue;
      const auto place = MeetingOf(slice.outline, Moved(other.outline, beside.shift));
      if (!place.has_value()) continue;
      const auto [copy, other_copy] = CopiesThat(slice.stack.object, beside, copies_);
      std::string names[] = {NameOfStack(slice.stack, copy), NameOfStack(other.stack, other_copy)};
      if (other_copy < copy) std::swap(names[0], names[1]);
      found_ = ConflictError(names[0], names[1], *place + copies_[copy].shift, slice.top_nm);
    }
  }
}

void ConflictPlanner::CompareBrims(const JobPlan& plan) {
  std::vector<Slice> brims;
  for (const AddedStack& added : plan.stacks) {
    if (added.stack.kind != StackKind::kBrim) continue;
    for (const ObjectSection& section : added.sections)
      brims.push_back(SliceOf(section, section.z_nm));
  }
  for (const Slice& brim : brims) {
    if (brim.stack.object != kPlateObject) near_.Claim(brim.stack.object, brim.box);
    low_[brim.stack.object].push_back(brim);
  }
  for (const Slice& brim : brims)
    if (brim.stack.object != kPlateObject) Compare(brim, low_);
}

std::vector<ConflictPlanner::Placed> ConflictPlanner::LowBeside(const Slice& slice) const {
  std::vector<Placed> placed;
  const auto add = [&](const Slice& other, Point shift, size_t copy) {
    const Box box = {other.box.min + shift, other.box.max + shift};
    if (other.stack != slice.stack && other.SharesHeight(slice) && box.Intersects(slice.box))
      placed.push_back({other.stack, copy, Moved(other.outline, shift)});
  };
  for (size_t copy = 0; copy < copies_.size(); ++copy)
    if (const auto own = low_.find(copies_[copy].object); own != low_.end())
      for (const Slice& other : own->second) add(other, copies_[copy].shift, copy);
  if (const auto plate = low_.find(kPlateObject); plate != low_.end())
    for (const Slice& other : plate->second) add(other, {}, 0);
  return placed;
}

void ConflictPlanner::ComparePlaced(const Slice& slice, const std::vector<Placed>& others) {
  std::vector<Polygon> rings;
  for (const Placed& other : others)
    for (Polygon& ring : Rings(other.outline)) rings.push_back(std::move(ring));
  // Tests the union of all other slices first, because there may be a thousand of them.
  if (!MeetingOf(slice.outline, Union(rings, FillRule::kNonZero)).has_value()) return;
  for (const Placed& other : others) {
    const auto place = MeetingOf(slice.outline, other.outline);
    if (!place.has_value() || !found_.ok()) continue;
    found_ = ConflictError(NameOfStack(slice.stack, 0), NameOfStack(other.stack, other.copy),
                           *place, slice.top_nm);
  }
}

void ConflictPlanner::CompareSkirt(const Skirt& skirt) {
  Slice slice;
  slice.stack = kSkirtStack;
  slice.outline = CoverOf(skirt.loops);
  if (slice.outline.empty()) return;
  std::vector<Placed> others;
  for (size_t copy = 0; copy < copies_.size(); ++copy)
    if (const auto hull = hulls_.find(copies_[copy].object); hull != hulls_.end())
      others.push_back({hull->first, copy, {{Moved(hull->second, copies_[copy].shift), {}}}});
  if (const auto plate = low_.find(kPlateObject); plate != low_.end())
    for (const Slice& low : plate->second) others.push_back({low.stack, 0, low.outline});
  ComparePlaced(slice, others);
}

std::string ConflictPlanner::NameOfStack(const Stack& stack, size_t copy) const {
  const bool on_plate = stack.object == kPlateObject;
  const std::string name = on_plate ? "" : NameOfCopy(copy, copies_, object_names_);
  switch (stack.kind) {
    case StackKind::kPart:
      return name;
    case StackKind::kSupport:
      return "the supports of " + name;
    case StackKind::kRaft:
      return on_plate ? "a raft" : "the raft of " + name;
    case StackKind::kBrim:
      return on_plate ? "a brim" : "the brim of " + name;
    case StackKind::kSkirt:
      return "the skirt";
  }
  return name;
}

absl::Status ConflictPlanner::Finish(const CancelToken& cancel, OpenLayers& /*layers*/,
                                     JobPlan& plan) {
  if (!found_.ok()) return found_;
  CompareBrims(plan);
  if (const auto plate = low_.find(kPlateObject); plate != low_.end())
    for (const Slice& slice : plate->second) {
      if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
      ComparePlaced(slice, LowBeside(slice));
    }
  CompareSkirt(plan.skirt);
  return found_;
}

}  // namespace slicefarm::planning
