#include "services/exposure/algo/expose_layer.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/layers/region_check.h"
#include "services/exposure/algo/expose_region.h"
#include "services/exposure/algo/scan/block_order.h"
#include "services/exposure/algo/scan/deep_outlines.h"
#include "services/exposure/algo/scan/melted_sample.h"

namespace slicefarm::exposure {
namespace {

/// Outlines of an object's layers above and below a layer, as many as the skins need.
struct Neighbours {
  std::vector<const MultiPolygon*> above, below;
};

Neighbours NeighboursOf(const ObjectSection& section, const ExposureOptions& options,
                        DeepOutlines& outlines) {
  Neighbours neighbours;
  for (int32_t i = 1; i <= options.upskin_layers; ++i)
    neighbours.above.push_back(outlines.Find(section.stack.id, section.layer + i));
  // Layers below the object's lowest layer do not exist: the plate is there.
  for (int32_t i = 1; i <= std::min(options.downskin_layers, section.layer); ++i)
    neighbours.below.push_back(outlines.Find(section.stack.id, section.layer - i));
  return neighbours;
}

Point ShiftOf(int32_t object, std::span<const Copy> copies) {
  const auto copy = std::ranges::find(copies, object, &Copy::object);
  return copy == copies.end() ? Point{} : copy->shift;
}

absl::Status AppendSection(const ObjectSection& section, int32_t layer, const ObjectLayers& objects,
                           std::span<const ExposureOptions> regions, std::span<const Copy> copies,
                           const CancelToken& cancel, ExposedLayer& result) {
  Point at;
  for (const Region& region : section.regions) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const ExposureOptions& options = regions[static_cast<size_t>(region.settings)];
    DeepOutlines deep(objects, options.z_compensation_layers);
    const MultiPolygon outlines = deep.Of(section, region.outlines);
    const Neighbours neighbours = NeighboursOf(section, options, deep);
    auto groups = ExposeRegion({.outlines = outlines,
                                .section = *deep.Find(section.stack.id, section.layer),
                                .neighbours = {neighbours.above, neighbours.below},
                                .layer = layer,
                                .object = section.stack.object,
                                .settings = region.settings,
                                .shift = ShiftOf(section.stack.object, copies)},
                               options, at, cancel, result.cuts);
    if (!groups.ok()) return groups.status();
    result.melted.Add(SampleMelted(*groups, outlines, options, layer));
    if (!groups->empty()) at = groups->back().points.back();
    std::move(groups->begin(), groups->end(), std::back_inserter(result.groups));
  }
  return absl::OkStatus();
}

/// Returns a block for each object: start, end and middle of the object's scan in this layer,
/// relative to the object's origin.
std::map<int32_t, ScanBlock> ObjectBlocks(const std::vector<ExposureGroup>& groups) {
  std::map<int32_t, ScanBlock> blocks;
  std::map<int32_t, Box> boxes;
  for (const ExposureGroup& group : groups) {
    const auto [block, is_new] = blocks.try_emplace(group.object);
    if (is_new) block->second.start = group.points.front();
    block->second.end = group.points.back();
    Box& box = boxes[group.object];
    box.Add(Bounds(group.points));
    block->second.middle = MiddleOf(box);
  }
  return blocks;
}

/// Returns the order of the blocks: against the gas flow if a region requests it, else nearest
/// first.
std::vector<BlockTurn> Ordered(const std::vector<ScanBlock>& blocks,
                               std::span<const ExposureOptions> regions) {
  for (const ExposureOptions& options : regions)
    if (options.jump_order == JumpOrder::kAgainstGas)
      return OrderBlocks(blocks, JumpOrder::kAgainstGas, {}, options.gas_flow_deg);
  return OrderBlocks(blocks, JumpOrder::kNearest, {});
}

/// Returns the visits of all copies of objects with groups in this layer, in the order of scanning.
std::vector<ExposureVisit> Visits(const std::vector<ExposureGroup>& groups,
                                  std::span<const Copy> copies,
                                  std::span<const ExposureOptions> regions) {
  const std::map<int32_t, ScanBlock> objects = ObjectBlocks(groups);
  std::vector<ExposureVisit> visits;
  std::vector<ScanBlock> blocks;
  const auto add = [&](int32_t object, int32_t copy, Point shift) {
    const auto found = objects.find(object);
    if (found == objects.end()) return;
    visits.push_back({object, copy, shift});
    blocks.push_back({.start = found->second.start + shift,
                      .end = found->second.end + shift,
                      .middle = found->second.middle + shift});
  };
  for (size_t i = 0; i < copies.size(); ++i)
    add(copies[i].object, static_cast<int32_t>(i), copies[i].shift);
  std::vector<ExposureVisit> ordered;
  for (const BlockTurn& turn : Ordered(blocks, regions)) ordered.push_back(visits[turn.block]);
  return ordered;
}

double AreaOfVisits(const SlicedLayer& layer, const std::vector<ExposureVisit>& visits) {
  std::map<int32_t, double> areas;
  for (const ObjectSection& section : layer.sections)
    for (const Region& region : section.regions)
      areas[section.stack.object] += Area(region.outlines) / kNmPerMm / kNmPerMm;
  double area = 0;
  for (const ExposureVisit& visit : visits) area += areas[visit.object];
  return area;
}

}  // namespace

absl::StatusOr<ExposedLayer> ExposeLayer(const SlicedLayer& layer, const ObjectLayers& objects,
                                         std::span<const ExposureOptions> regions,
                                         std::span<const Copy> copies, const CancelToken& cancel) {
  if (absl::Status ok = CheckRegions(layer, regions.size()); !ok.ok()) return ok;
  ExposedLayer result;
  result.frame = layer.frame;
  for (const ObjectSection& section : layer.sections) {
    absl::Status status =
        AppendSection(section, layer.frame.index, objects, regions, copies, cancel, result);
    if (!status.ok()) return status;
  }
  result.visits = Visits(result.groups, copies, regions);
  result.area_mm2 = AreaOfVisits(layer, result.visits);
  return result;
}

}  // namespace slicefarm::exposure
