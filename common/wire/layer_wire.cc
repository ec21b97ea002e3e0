#include "common/wire/layer_wire.h"

#include <fmt/core.h>

#include <utility>

#include "common/model/limits.h"
#include "common/wire/geometry_wire.h"
#include "common/wire/path_wire.h"
#include "common/wire/repeated_wire.h"

namespace slicefarm {
namespace {

bool IsHeight(Coord nm) { return 0 < nm && nm <= limits::kMaxCoord; }

absl::Status CheckObject(int32_t object) {
  if (0 <= object && object < limits::kMaxObjects) return absl::OkStatus();
  return Malformed("object", "is not the index of an object");
}

}  // namespace

absl::Status ToProto(const ObjectSection& section, v1::ObjectSection* proto) {
  proto->set_object(section.object);
  return ToProto(section.outlines, proto->mutable_outlines());
}

absl::StatusOr<ObjectSection> FromProto(const v1::ObjectSection& proto) {
  if (absl::Status status = CheckObject(proto.object()); !status.ok()) return status;
  absl::StatusOr<MultiPolygon> outlines = FromProto(proto.outlines());
  if (!outlines.ok()) return Within("outlines", outlines.status());
  return ObjectSection{proto.object(), *std::move(outlines)};
}

absl::Status ToProto(const WalledIsland& island, v1::WalledIsland* proto) {
  proto->set_object(island.object);
  if (absl::Status status = AllToProto(island.walls, "walls", proto->mutable_walls());
      !status.ok()) {
    return status;
  }
  return ToProto(island.fill_area, proto->mutable_fill_area());
}

absl::StatusOr<WalledIsland> FromProto(const v1::WalledIsland& proto) {
  WalledIsland island;
  island.object = proto.object();
  if (absl::Status status = CheckObject(island.object); !status.ok()) return status;
  if (absl::Status status = AllFromProto(proto.walls(), "walls", &island.walls); !status.ok()) {
    return status;
  }
  absl::StatusOr<MultiPolygon> fill_area = FromProto(proto.fill_area());
  if (!fill_area.ok()) return Within("fill_area", fill_area.status());
  island.fill_area = *std::move(fill_area);
  return island;
}

absl::Status ToProto(const FillGroup& group, v1::FillGroup* proto) {
  proto->set_keep_order(group.keep_order);
  return AllToProto(group.paths, "paths", proto->mutable_paths());
}

absl::StatusOr<FillGroup> FromProto(const v1::FillGroup& proto) {
  FillGroup group;
  group.keep_order = proto.keep_order();
  if (absl::Status status = AllFromProto(proto.paths(), "paths", &group.paths); !status.ok()) {
    return status;
  }
  return group;
}

absl::Status ToProto(const FilledIsland& island, v1::FilledIsland* proto) {
  proto->set_object(island.object);
  if (absl::Status status = AllToProto(island.walls, "walls", proto->mutable_walls());
      !status.ok()) {
    return status;
  }
  return AllToProto(island.fills, "fills", proto->mutable_fills());
}

absl::StatusOr<FilledIsland> FromProto(const v1::FilledIsland& proto) {
  FilledIsland island;
  island.object = proto.object();
  if (absl::Status status = CheckObject(island.object); !status.ok()) return status;
  if (absl::Status status = AllFromProto(proto.walls(), "walls", &island.walls); !status.ok()) {
    return status;
  }
  if (absl::Status status = AllFromProto(proto.fills(), "fills", &island.fills); !status.ok()) {
    return status;
  }
  return island;
}

void ToProto(const LayerFrame& frame, v1::LayerFrame* proto) {
  proto->set_index(frame.index);
  proto->set_print_z_nm(frame.print_z_nm);
  proto->set_height_nm(frame.height_nm);
  proto->set_plain_islands(frame.plain_islands);
}

absl::StatusOr<LayerFrame> FromProto(const v1::LayerFrame& proto) {
  if (proto.index() < 0 || proto.index() >= limits::kMaxLayers) {
    return Malformed("frame.index", "is not the index of a layer");
  }
  if (!IsHeight(proto.print_z_nm())) return Malformed("frame.print_z_nm", "is not a height");
  if (!IsHeight(proto.height_nm())) return Malformed("frame.height_nm", "is not a height");
  if (proto.plain_islands() < 0) return Malformed("frame.plain_islands", "is negative");
  return LayerFrame{proto.index(), proto.print_z_nm(), proto.height_nm(), proto.plain_islands()};
}

v1::LayerRange ToProto(LayerRange range) {
  v1::LayerRange proto;
  proto.set_first(range.first);
  proto.set_last(range.last);
  return proto;
}

absl::StatusOr<LayerRange> FromProto(const v1::LayerRange& proto, int32_t layer_count) {
  if (layer_count < 1 || layer_count > limits::kMaxLayers) {
    return Malformed("layer_count", fmt::format("is not in 1..{}", limits::kMaxLayers));
  }
  if (proto.first() < 0 || proto.first() >= proto.last() || proto.last() > layer_count) {
    return Malformed("range", fmt::format("[{}, {}) is no range of {} layers", proto.first(),
                                          proto.last(), layer_count));
  }
  return LayerRange{proto.first(), proto.last()};
}

absl::Status ToProto(const SlicedLayer& layer, v1::SlicedLayer* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  return AllToProto(layer.objects, "objects", proto->mutable_objects());
}

absl::StatusOr<SlicedLayer> FromProto(const v1::SlicedLayer& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  SlicedLayer layer{*frame, {}};
  if (absl::Status status = AllFromProto(proto.objects(), "objects", &layer.objects);
      !status.ok()) {
    return status;
  }
  for (size_t i = 1; i < layer.objects.size(); ++i) {
    if (layer.objects[i - 1].object >= layer.objects[i].object) {
      return Malformed("objects", "do not ascend");
    }
  }
  return layer;
}

absl::Status ToProto(const WalledLayer& layer, v1::WalledLayer* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  return AllToProto(layer.islands, "islands", proto->mutable_islands());
}

absl::StatusOr<WalledLayer> FromProto(const v1::WalledLayer& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  WalledLayer layer{*frame, {}};
  if (absl::Status status = AllFromProto(proto.islands(), "islands", &layer.islands);
      !status.ok()) {
    return status;
  }
  return layer;
}

absl::Status ToProto(const FilledLayer& layer, v1::FilledLayer* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  return AllToProto(layer.islands, "islands", proto->mutable_islands());
}

absl::StatusOr<FilledLayer> FromProto(const v1::FilledLayer& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  FilledLayer layer{*frame, {}};
  if (absl::Status status = AllFromProto(proto.islands(), "islands", &layer.islands);
      !status.ok()) {
    return status;
  }
  return layer;
}

absl::Status ToProto(const OrderedLayer& layer, v1::OrderedLayer* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  return AllToProto(layer.paths, "paths", proto->mutable_paths());
}

absl::StatusOr<OrderedLayer> FromProto(const v1::OrderedLayer& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  OrderedLayer layer{*frame, {}};
  if (absl::Status status = AllFromProto(proto.paths(), "paths", &layer.paths); !status.ok()) {
    return status;
  }
  return layer;
}

absl::Status ToProto(const LayerPlan& plan, v1::LayerPlan* proto) {
  if (absl::Status status = ToProto(plan.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  return PackPoints(plan.seams, proto->mutable_seams_xy_nm());
}

absl::StatusOr<LayerPlan> FromProto(const v1::LayerPlan& proto) {
  absl::StatusOr<std::vector<Point>> seams = UnpackPoints(proto.seams_xy_nm(), "seams_xy_nm");
  if (!seams.ok()) return seams.status();
  return LayerPlan{FromProto(proto.entry()), *std::move(seams)};
}

absl::Status CheckNeighbourhood(std::span<const SlicedLayer> layers, LayerRange range,
                                int32_t layer_count) {
  if (absl::Status status = CheckConsecutive(layers); !status.ok()) return status;
  const LayerRange sent = RangeOf(layers);
  if (sent.first > range.first || sent.last < range.last || sent.last > layer_count) {
    return Malformed("layer", fmt::format("layers [{}, {}) do not surround the range in the job",
                                          sent.first, sent.last));
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
