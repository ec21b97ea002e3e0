#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "common/wire/wire_error.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// Layers from slicing to ordering (programs: program_wire.h). Errors are those of geometry_wire.h
/// and path_wire.h, with the way to the field: `islands[2].walls[7].xy_nm`; besides, indices and
/// ranges that no job has are REQUEST_MALFORMED.

void ToProto(const LayerFrame& frame, v1::LayerFrame* proto);
absl::StatusOr<LayerFrame> FromProto(const v1::LayerFrame& proto);

v1::LayerRange ToProto(LayerRange range);
/// A range of a job of `layer_count` layers: 0 <= first < last <= layer_count <=
/// limits::kMaxLayers.
absl::StatusOr<LayerRange> FromProto(const v1::LayerRange& proto, int32_t layer_count);

absl::Status ToProto(const ObjectSection& section, v1::ObjectSection* proto);
absl::StatusOr<ObjectSection> FromProto(const v1::ObjectSection& proto);

absl::Status ToProto(const SlicedLayer& layer, v1::SlicedLayer* proto);
absl::StatusOr<SlicedLayer> FromProto(const v1::SlicedLayer& proto);

absl::Status ToProto(const WalledIsland& island, v1::WalledIsland* proto);
absl::StatusOr<WalledIsland> FromProto(const v1::WalledIsland& proto);

absl::Status ToProto(const WalledLayer& layer, v1::WalledLayer* proto);
absl::StatusOr<WalledLayer> FromProto(const v1::WalledLayer& proto);

absl::Status ToProto(const FillGroup& group, v1::FillGroup* proto);
absl::StatusOr<FillGroup> FromProto(const v1::FillGroup& proto);

absl::Status ToProto(const FilledIsland& island, v1::FilledIsland* proto);
absl::StatusOr<FilledIsland> FromProto(const v1::FilledIsland& proto);

absl::Status ToProto(const FilledLayer& layer, v1::FilledLayer* proto);
absl::StatusOr<FilledLayer> FromProto(const v1::FilledLayer& proto);

absl::Status ToProto(const OrderedLayer& layer, v1::OrderedLayer* proto);
absl::StatusOr<OrderedLayer> FromProto(const v1::OrderedLayer& proto);

absl::Status ToProto(const LayerPlan& plan, v1::LayerPlan* proto);
absl::StatusOr<LayerPlan> FromProto(const v1::LayerPlan& proto);

/// What a stage of a range needs: consecutive layers that contain the range and do not leave the
/// job.
absl::Status CheckNeighbourhood(std::span<const SlicedLayer> layers, LayerRange range,
                                int32_t layer_count);

/// One layer for each of the range, in order.
template <typename Layer>
absl::Status CheckLayersOfRange(const std::vector<Layer>& layers, LayerRange range) {
  if (layers.size() != static_cast<size_t>(range.size())) {
    return Malformed("layer", "not one for each layer of the range");
  }
  for (int32_t i = 0; i < range.size(); ++i) {
    if (layers[i].frame.index != range.first + i) return Malformed("layer", "out of order");
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
