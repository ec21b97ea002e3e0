#include "services/planning/algo/sequence/sequence_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/convex.h"
#include "common/model/limits.h"
#include "services/planning/algo/sequence/print_sequence.h"

namespace slicefarm::planning {

void SequencePlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  (void)plan;
  for (const ObjectSection& section : layer.sections) {
    if (!section.stack.IsPart() || section.regions.empty()) continue;
    Printed& printed = printed_[section.stack.object];
    printed.top_nm = layer.frame.print_z_nm;
    printed.layers = section.layer + 1;
  }
}

absl::Status SequencePlanner::CheckLayers() const {
  int64_t layers = 0;
  for (const PlacedCopy& copy : copies_)
    if (const auto found = printed_.find(copy.object); found != printed_.end())
      layers += found->second.layers;
  if (layers <= limits::kMaxLayerPrograms) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "layers of all copies, printed one after the other",
                    limits::kMaxLayerPrograms, layers);
}

Polygon SequencePlanner::FootprintOf(const PlacedCopy& copy,
                                     std::span<const AddedStack> added) const {
  Polygon points = copy.footprint;
  for (const AddedStack& stack : added) {
    if (stack.stack.object != copy.object) continue;
    for (const ObjectSection& section : stack.sections)
      for (const Region& region : section.regions)
        for (const PolygonWithHoles& island : region.outlines)
          for (const Point p : island.outer) points.push_back(p + copy.shift);
  }
  return points.size() == copy.footprint.size() ? points : ConvexHull(std::move(points));
}

absl::Status SequencePlanner::Finish(const CancelToken& cancel, OpenLayers& /*layers*/,
                                     JobPlan& plan) {
  if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
  if (absl::Status ok = CheckLayers(); !ok.ok()) return ok;
  std::vector<SequenceItem> items;
  std::vector<size_t> copy_of;  // copy index by item
  for (size_t i = 0; i < copies_.size(); ++i) {
    const auto printed = printed_.find(copies_[i].object);
    if (printed == printed_.end()) continue;
    items.push_back({FootprintOf(copies_[i], plan.stacks), printed->second.top_nm,
                     NameOfCopy(i, copies_, object_names_)});
    copy_of.push_back(i);
  }
  SequenceOptions sequence{.clearance_radius_nm = options_.clearance_radius_nm,
                           .clearance_height_nm = options_.clearance_height_nm,
                           .nozzle_height_nm = options_.nozzle_height_nm};
  if (options_.lid_height_nm > 0) {
    sequence.lid_height_nm = options_.lid_height_nm;
    sequence.gantry_reach_nm = options_.gantry_reach_nm;
  }
  const auto order = PrintSequence(items, sequence);
  if (!order.ok()) return order.status();
  int32_t pass = 0;
  for (const size_t item : *order) plan.copies[copy_of[item]].pass = pass++;
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
