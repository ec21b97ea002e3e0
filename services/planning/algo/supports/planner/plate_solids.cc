#include "services/planning/algo/supports/planner/plate_solids.h"

#include <algorithm>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"

namespace slicefarm::planning {
namespace {

SolidLayer LayerOf(const ObjectSection& section, Coord top_nm) {
  return {top_nm, section.height_nm, &OutlineOf(section)};
}

const MultiPolygon* MarkOrNull(const ObjectSection& section, PartRole role) {
  const MultiPolygon& marked = MarkedIn(section, role);
  return marked.empty() ? nullptr : &marked;
}

Polygon RingOf(const Box& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

Box MovedBox(const Box& box, Point shift) { return {box.min + shift, box.max + shift}; }

/// Returns the larger of the gaps between two boxes along x and y; 0 if they meet.
Coord GapOf(const Box& a, const Box& b) {
  const Coord x = std::max(a.min.x - b.max.x, b.min.x - a.max.x);
  const Coord y = std::max(a.min.y - b.max.y, b.min.y - a.max.y);
  return std::max<Coord>(0, std::max(x, y));
}

}  // namespace

PlateSolids::PlateSolids(std::span<const SlicedLayer> parts, std::span<const PlacedCopy> copies)
    : copies_(copies) {
  for (const SlicedLayer& layer : parts) {
    for (const ObjectSection& section : layer.sections) {
      Solid& solid = solids_[section.stack.object];
      const SolidLayer own = LayerOf(section, layer.frame.print_z_nm);
      if (solid.stacks.empty()) solid.stacks.emplace_back();
      solid.stacks.front().push_back(own);
      solid.part.push_back({own, MarkOrNull(section, PartRole::kSupportEnforcer),
                            MarkOrNull(section, PartRole::kSupportBlocker)});
      solid.box.Add(Bounds(*own.outlines));
    }
  }
}

void PlateSolids::Add(const AddedStack& support) {
  Solid& solid = solids_[support.stack.object];
  std::vector<SolidLayer>& layers = solid.stacks.emplace_back();
  for (const ObjectSection& section : support.sections) {
    layers.push_back(LayerOf(section, section.z_nm));
    solid.box.Add(Bounds(*layers.back().outlines));
  }
}

void PlateSolids::AddAround(const Solid& object, const Solid& other, Point shift,
                            Coord clearance_nm, SupportProblem& problem) {
  if (!object.box.Grown(clearance_nm).Intersects(MovedBox(other.box, shift))) return;
  for (const std::vector<SolidLayer>& stack : other.stacks) {
    std::vector<SolidLayer>& layers = problem.others.emplace_back();
    for (const SolidLayer& layer : stack) {
      if (layer.outlines->empty()) continue;
      layers.push_back(
          {layer.top_nm, layer.height_nm, &moved_.emplace_back(Moved(*layer.outlines, shift))});
    }
  }
}

SupportProblem PlateSolids::ProblemOf(int32_t object, const MultiPolygon& bed, Coord clearance_nm) {
  const Solid& own = solids_.at(object);
  SupportProblem problem;
  problem.part = own.part;
  for (const PlacedCopy& copy : copies_) {
    if (copy.object != object) continue;
    for (const PlacedCopy& other : copies_) {
      const auto solid = solids_.find(other.object);
      if (&other == &copy || solid == solids_.end()) continue;
      const Point shift = other.shift - copy.shift;
      if (other.object == object)
        clearance_nm = std::min(clearance_nm, GapOf(own.box, MovedBox(own.box, shift)) / 2);
      AddAround(own, solid->second, shift, clearance_nm, problem);
    }
  }
  problem.bed = {{RingOf(own.box.Grown(clearance_nm)), {}}};
  for (const PlacedCopy& copy : copies_)
    if (copy.object == object && !bed.empty())
      problem.bed = Intersection(problem.bed, Moved(bed, Point{} - copy.shift));
  return problem;
}

}  // namespace slicefarm::planning
