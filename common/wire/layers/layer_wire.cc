#include "common/wire/layers/layer_wire.h"

#include <fmt/core.h>

#include <utility>

#include "common/model/limits.h"
#include "common/wire/layers/fill_stats_wire.h"
#include "common/wire/layers/path_wire.h"
#include "common/wire/layers/region_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/repeated_wire.h"

namespace slicefarm {
namespace {

bool IsHeight(Coord nm) { return 0 < nm && nm <= limits::kMaxCoord; }

absl::Status SurfaceToProto(std::span<const SurfaceFacet> facets, v1::SurfaceFacets* proto) {
  for (const SurfaceFacet& facet : facets) {
    if (absl::Status ok = PackPoints(facet.corners, proto->mutable_corners_xy_nm()); !ok.ok())
      return Within("surface", ok);
    for (const Coord up_nm : facet.up_nm) {
      if (absl::Status ok = CheckCoord(up_nm); !ok.ok()) return Within("surface", ok);
      proto->add_up_nm(static_cast<int32_t>(up_nm));
    }
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<SurfaceFacet>> SurfaceFromProto(const v1::SurfaceFacets& proto) {
  const auto corners = UnpackPoints(proto.corners_xy_nm(), "surface.corners_xy_nm");
  if (!corners.ok()) return corners.status();
  if (corners->size() % 3 != 0 || std::ssize(*corners) != proto.up_nm_size())
    return Malformed("surface", "does not have three corners and heights for each facet");
  std::vector<SurfaceFacet> facets(corners->size() / 3);
  for (size_t i = 0; i < corners->size(); ++i) {
    facets[i / 3].corners[i % 3] = (*corners)[i];
    facets[i / 3].up_nm[i % 3] = proto.up_nm(static_cast<int>(i));
  }
  return facets;
}

/// Converts the members that all kinds of section share.
template <typename Section, typename Proto>
void PlaceToProto(const Section& section, Proto* proto) {
  ToProto(section.stack, proto->mutable_stack());
  proto->set_layer(section.layer);
  proto->set_height_nm(section.height_nm);
}

template <typename Section, typename Proto>
absl::StatusOr<Section> PlaceFromProto(const Proto& proto) {
  absl::Status status = CheckSection(proto.layer(), proto.height_nm());
  if (!status.ok()) return status;
  const absl::StatusOr<Stack> stack = FromProto(proto.stack());
  if (!stack.ok()) return stack.status();
  Section section;
  section.stack = *stack;
  section.layer = proto.layer();
  section.height_nm = proto.height_nm();
  return section;
}

/// Converts walls and fills, which are in sections of islands.
template <typename Section, typename Proto>
absl::Status SectionToProto(const Section& section, Proto* proto) {
  PlaceToProto(section, proto);
  return AllToProto(section.islands, "islands", proto->mutable_islands());
}

template <typename Section, typename Proto>
absl::StatusOr<Section> SectionFromProto(const Proto& proto) {
  absl::StatusOr<Section> section = PlaceFromProto<Section>(proto);
  if (!section.ok()) return section;
  absl::Status status = AllFromProto(proto.islands(), "islands", &section->islands);
  if (!status.ok()) return status;
  return section;
}

/// Converts an island's outline, which is one polygon or none.
template <typename Island, typename Proto>
absl::Status OutlineToProto(const Island& island, Proto* proto) {
  if (island.outline.outer.empty()) return absl::OkStatus();
  absl::Status status = ToProto(MultiPolygon{island.outline}, proto->mutable_outline());
  return status.ok() ? status : Within("outline", status);
}

template <typename Island, typename Proto>
absl::Status OutlineFromProto(const Proto& proto, Island* island) {
  absl::StatusOr<MultiPolygon> outline = FromProto(proto.outline());
  if (!outline.ok()) return Within("outline", outline.status());
  if (outline->size() > 1) return Malformed("outline", "is of more than one island");
  if (!outline->empty()) island->outline = std::move(outline->front());
  return absl::OkStatus();
}

/// Converts layers, which consist of a frame and sections.
template <typename Layer, typename Proto>
absl::Status LayerToProto(const Layer& layer, Proto* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  return AllToProto(layer.sections, "sections", proto->mutable_sections());
}

template <typename Layer, typename Proto>
absl::StatusOr<Layer> LayerFromProto(const Proto& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  Layer layer;
  layer.frame = *frame;
  absl::Status status = AllFromProto(proto.sections(), "sections", &layer.sections);
  if (!status.ok()) return status;
  for (size_t i = 1; i < layer.sections.size(); ++i) {
    if (layer.sections[i - 1].stack.id >= layer.sections[i].stack.id)
      return Malformed("sections", "their stacks do not ascend");
  }
  return layer;
}

}  // namespace

void ToProto(const LayerFrame& frame, v1::LayerFrame* proto) {
  proto->set_index(frame.index);
  proto->set_print_z_nm(frame.print_z_nm);
  proto->set_height_nm(frame.height_nm);
}

absl::StatusOr<LayerFrame> FromProto(const v1::LayerFrame& proto) {
  if (proto.index() < 0 || proto.index() >= limits::kMaxLayers) {
    return Malformed("frame.index", "is not the index of a layer");
  }
  if (!IsHeight(proto.print_z_nm())) return Malformed("frame.print_z_nm", "is not a height");
  if (!IsHeight(proto.height_nm())) return Malformed("frame.height_nm", "is not a height");
  return LayerFrame{proto.index(), proto.print_z_nm(), proto.height_nm()};
}

v1::LayerRange ToProto(LayerRange range) {
  v1::LayerRange proto;
  proto.set_first(range.first);
  proto.set_last(range.last);
  return proto;
}

absl::StatusOr<LayerRange> FromProto(const v1::LayerRange& proto) {
  if (proto.first() < 0 || proto.first() >= proto.last() || proto.last() > limits::kMaxLayers) {
    return Malformed("range", fmt::format("[{}, {}) is no range of at most {} layers",
                                          proto.first(), proto.last(), limits::kMaxLayers));
  }
  return LayerRange{proto.first(), proto.last()};
}

absl::Status ToProto(const ObjectSection& section, v1::ObjectSection* proto) {
  PlaceToProto(section, proto);
  proto->set_layer_count(section.layer_count);
  proto->set_z_nm(section.z_nm);
  proto->set_hollow(section.hollow);
  absl::Status status = AllToProto(section.regions, "regions", proto->mutable_regions());
  if (!section.whole.empty()) status.Update(ToProto(section.whole, proto->mutable_whole()));
  status.Update(AllToProto(section.marks, "marks", proto->mutable_marks()));
  if (!section.surface.empty())
    status.Update(SurfaceToProto(section.surface, proto->mutable_surface()));
  return status;
}

absl::StatusOr<ObjectSection> FromProto(const v1::ObjectSection& proto) {
  absl::StatusOr<ObjectSection> section = PlaceFromProto<ObjectSection>(proto);
  if (!section.ok()) return section;
  section->layer_count = proto.layer_count();
  if (section->layer_count <= section->layer || section->layer_count > limits::kMaxLayers) {
    return Malformed("layer_count", "is not how many layers a stack has");
  }
  absl::Status status = AllFromProto(proto.regions(), "regions", &section->regions);
  if (!status.ok()) return status;
  absl::StatusOr<MultiPolygon> whole = FromProto(proto.whole());
  if (!whole.ok()) return Within("whole", whole.status());
  section->whole = *std::move(whole);
  status = AllFromProto(proto.marks(), "marks", &section->marks);
  if (!status.ok()) return status;
  auto surface = SurfaceFromProto(proto.surface());
  if (!surface.ok()) return surface.status();
  section->surface = *std::move(surface);
  section->hollow = proto.hollow();
  section->z_nm = proto.z_nm();
  if (section->z_nm < 0 || section->z_nm > limits::kMaxCoord)
    return Malformed("z_nm", "is not a height");
  return section;
}

absl::Status ToProto(const WalledIsland& island, v1::WalledIsland* proto) {
  absl::Status status = AllToProto(island.walls, "walls", proto->mutable_walls());
  status.Update(OutlineToProto(island, proto));
  if (!status.ok()) return status;
  return AllToProto(island.fill_areas, "fill_areas", proto->mutable_fill_areas());
}

absl::StatusOr<WalledIsland> FromProto(const v1::WalledIsland& proto) {
  WalledIsland island;
  absl::Status status = AllFromProto(proto.walls(), "walls", &island.walls);
  status.Update(AllFromProto(proto.fill_areas(), "fill_areas", &island.fill_areas));
  status.Update(OutlineFromProto(proto, &island));
  if (!status.ok()) return status;
  return island;
}

absl::Status ToProto(const WalledSection& section, v1::WalledSection* proto) {
  return SectionToProto(section, proto);
}
absl::StatusOr<WalledSection> FromProto(const v1::WalledSection& proto) {
  return SectionFromProto<WalledSection>(proto);
}

absl::Status ToProto(const FillGroup& group, v1::FillGroup* proto) {
  proto->set_keep_order(group.keep_order);
  return AllToProto(group.paths, "paths", proto->mutable_paths());
}

absl::StatusOr<FillGroup> FromProto(const v1::FillGroup& proto) {
  FillGroup group;
  group.keep_order = proto.keep_order();
  absl::Status status = AllFromProto(proto.paths(), "paths", &group.paths);
  if (!status.ok()) return status;
  return group;
}

absl::Status ToProto(const FilledIsland& island, v1::FilledIsland* proto) {
  absl::Status status = AllToProto(island.walls, "walls", proto->mutable_walls());
  status.Update(OutlineToProto(island, proto));
  if (!status.ok()) return status;
  return AllToProto(island.fills, "fills", proto->mutable_fills());
}

absl::StatusOr<FilledIsland> FromProto(const v1::FilledIsland& proto) {
  FilledIsland island;
  absl::Status status = AllFromProto(proto.walls(), "walls", &island.walls);
  status.Update(AllFromProto(proto.fills(), "fills", &island.fills));
  status.Update(OutlineFromProto(proto, &island));
  if (!status.ok()) return status;
  return island;
}

absl::Status ToProto(const FilledSection& section, v1::FilledSection* proto) {
  absl::Status status = SectionToProto(section, proto);
  status.Update(AllToProto(section.uses, "uses", proto->mutable_uses()));
  return status;
}
absl::StatusOr<FilledSection> FromProto(const v1::FilledSection& proto) {
  absl::StatusOr<FilledSection> section = SectionFromProto<FilledSection>(proto);
  if (!section.ok()) return section;
  absl::Status status = AllFromProto(proto.uses(), "uses", &section->uses);
  if (!status.ok()) return status;
  return section;
}

absl::Status ToProto(const SlicedLayer& layer, v1::SlicedLayer* proto) {
  return LayerToProto(layer, proto);
}
absl::StatusOr<SlicedLayer> FromProto(const v1::SlicedLayer& proto) {
  return LayerFromProto<SlicedLayer>(proto);
}

absl::Status ToProto(const WalledLayer& layer, v1::WalledLayer* proto) {
  proto->set_plain_islands(layer.plain_islands);
  return LayerToProto(layer, proto);
}
absl::StatusOr<WalledLayer> FromProto(const v1::WalledLayer& proto) {
  absl::StatusOr<WalledLayer> layer = LayerFromProto<WalledLayer>(proto);
  if (!layer.ok()) return layer;
  layer->plain_islands = proto.plain_islands();
  if (layer->plain_islands < 0) return Malformed("plain_islands", "is negative");
  return layer;
}

absl::Status ToProto(const FilledLayer& layer, v1::FilledLayer* proto) {
  return LayerToProto(layer, proto);
}
absl::StatusOr<FilledLayer> FromProto(const v1::FilledLayer& proto) {
  return LayerFromProto<FilledLayer>(proto);
}

absl::Status ToProto(const Travel& travel, v1::Travel* proto) {
  proto->set_hidden(travel.hidden);
  proto->set_over_wall(travel.over_wall);
  return PackPoints(travel.corners, proto->mutable_corners_xy_nm());
}

absl::StatusOr<Travel> FromProto(const v1::Travel& proto) {
  absl::StatusOr<std::vector<Point>> corners = UnpackPoints(proto.corners_xy_nm(), "corners_xy_nm");
  if (!corners.ok()) return corners.status();
  return Travel{proto.hidden(), *std::move(corners), proto.over_wall()};
}

absl::Status ToProto(const ExitTravel& exit_travel, v1::ExitTravel* proto) {
  if (absl::Status status = ToProto(exit_travel.to, proto->mutable_to()); !status.ok())
    return Within("to", status);
  const absl::Status status = ToProto(exit_travel.travel, proto->mutable_travel());
  return status.ok() ? status : Within("travel", status);
}

absl::StatusOr<ExitTravel> FromProto(const v1::ExitTravel& proto) {
  absl::StatusOr<Travel> travel = FromProto(proto.travel());
  if (!travel.ok()) return Within("travel", travel.status());
  return ExitTravel{FromProto(proto.to()), *std::move(travel)};
}

absl::Status ToProto(const SpiralTurn& turn, v1::SpiralTurn* proto) {
  proto->set_last(turn.last);
  proto->set_blends(turn.blends);
  absl::Status status = ToProto(turn.start, proto->mutable_start());
  if (turn.from) status.Update(ToProto(*turn.from, proto->mutable_from()));
  return status;
}

SpiralTurn FromProto(const v1::SpiralTurn& proto) {
  SpiralTurn turn{FromProto(proto.start()), {}, proto.last(), proto.blends()};
  if (proto.has_from()) turn.from = FromProto(proto.from());
  return turn;
}

absl::Status ToProto(const PathBlock& block, v1::PathBlock* proto) {
  PlaceToProto(block, proto);
  absl::Status status = AllToProto(block.paths, "paths", proto->mutable_paths());
  if (!status.ok()) return status;
  status = AllToProto(block.travels, "travels", proto->mutable_travels());
  if (!status.ok()) return status;
  if (block.exit_travel) {
    status = ToProto(*block.exit_travel, proto->mutable_exit_travel());
    if (!status.ok()) return Within("exit_travel", status);
  }
  if (block.spiral) {
    status = ToProto(*block.spiral, proto->mutable_spiral());
    if (!status.ok()) return Within("spiral", status);
  }
  if (!block.above_supports.empty()) {
    status = ToProto(block.above_supports, proto->mutable_above_supports());
    if (!status.ok()) return Within("above_supports", status);
  }
  if (!block.curled.empty()) {
    status = ToProto(block.curled, proto->mutable_curled());
    if (!status.ok()) return Within("curled", status);
  }
  if (!block.surface.empty()) {
    status = SurfaceToProto(block.surface, proto->mutable_surface());
    if (!status.ok()) return status;
  }
  if (block.below.empty()) return status;
  status = ToProto(block.below, proto->mutable_below());
  return status.ok() ? status : Within("below", status);
}

absl::StatusOr<PathBlock> FromProto(const v1::PathBlock& proto) {
  absl::StatusOr<PathBlock> block = PlaceFromProto<PathBlock>(proto);
  if (!block.ok()) return block;
  absl::Status status = AllFromProto(proto.paths(), "paths", &block->paths);
  status.Update(AllFromProto(proto.travels(), "travels", &block->travels));
  if (!status.ok()) return status;
  if (!block->travels.empty() && block->travels.size() != block->paths.size()) {
    return Malformed("travels", "not one for each path");
  }
  if (proto.has_exit_travel()) {
    absl::StatusOr<ExitTravel> exit_travel = FromProto(proto.exit_travel());
    if (!exit_travel.ok()) return Within("exit_travel", exit_travel.status());
    block->exit_travel = *std::move(exit_travel);
  }
  absl::StatusOr<MultiPolygon> below = FromProto(proto.below());
  if (!below.ok()) return Within("below", below.status());
  block->below = *std::move(below);
  absl::StatusOr<MultiPolygon> above_supports = FromProto(proto.above_supports());
  if (!above_supports.ok()) return Within("above_supports", above_supports.status());
  block->above_supports = *std::move(above_supports);
  absl::StatusOr<MultiPolygon> curled = FromProto(proto.curled());
  if (!curled.ok()) return Within("curled", curled.status());
  block->curled = *std::move(curled);
  auto surface = SurfaceFromProto(proto.surface());
  if (!surface.ok()) return surface.status();
  block->surface = *std::move(surface);
  if (proto.has_spiral()) block->spiral = FromProto(proto.spiral());
  return block;
}

absl::Status ToProto(const BlockVisit& visit, v1::BlockVisit* proto) {
  proto->set_block(visit.block);
  proto->set_copy(visit.copy);
  proto->set_pass(visit.pass);
  const absl::Status status = PackPoints(visit.corners, proto->mutable_corners_xy_nm());
  if (!status.ok()) return Within("corners_xy_nm", status);
  return ToProto(visit.shift, proto->mutable_shift());
}

absl::StatusOr<BlockVisit> FromProto(const v1::BlockVisit& proto) {
  if (proto.block() < 0) return Malformed("block", "is negative");
  if (proto.copy() < -1 || proto.copy() >= limits::kMaxObjects) {
    return Malformed("copy", "is not the index of a copy");
  }
  if (proto.pass() < 0) return Malformed("pass", "is negative");
  absl::StatusOr<std::vector<Point>> corners = UnpackPoints(proto.corners_xy_nm(), "corners_xy_nm");
  if (!corners.ok()) return corners.status();
  return BlockVisit{proto.block(), proto.copy(), proto.pass(), FromProto(proto.shift()),
                    *std::move(corners)};
}

absl::Status ToProto(const OrderedLayer& layer, v1::OrderedLayer* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  proto->set_begins_ready(layer.begins_ready);
  proto->set_ends_ready(layer.ends_ready);
  absl::Status status = AllToProto(layer.blocks, "blocks", proto->mutable_blocks());
  if (!status.ok()) return status;
  return AllToProto(layer.visits, "visits", proto->mutable_visits());
}

absl::StatusOr<OrderedLayer> FromProto(const v1::OrderedLayer& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  OrderedLayer layer{*frame, {}, {}, proto.begins_ready(), proto.ends_ready()};
  absl::Status status = AllFromProto(proto.blocks(), "blocks", &layer.blocks);
  status.Update(AllFromProto(proto.visits(), "visits", &layer.visits));
  if (!status.ok()) return status;
  return layer;
}

absl::Status CheckNeighbourhood(std::span<const SlicedLayer> layers, LayerRange range) {
  if (absl::Status status = CheckConsecutive(layers); !status.ok()) return status;
  const LayerRange sent = RangeOf(layers);
  if (sent.first > range.first || sent.last < range.last) {
    return Malformed(
        "layer", fmt::format("layers [{}, {}) do not surround the range", sent.first, sent.last));
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
