#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/wire/support/wire_error.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

// Conversion of layers: results of the stages from slicing to ordering (for programs:
// program_wire.h). Errors: see geometry_wire.h and path_wire.h, with the path to the field, such
// as `islands[2].walls[7].xy_nm`. REQUEST_MALFORMED for indices and ranges that no job can have.

/// Converts a layer frame to its message and back.
void ToProto(const LayerFrame& frame, v1::LayerFrame* proto);
absl::StatusOr<LayerFrame> FromProto(const v1::LayerFrame& proto);

/// Converts a layer range to its message and back.
v1::LayerRange ToProto(LayerRange range);
/// Converts a range of layers. Errors: REQUEST_MALFORMED unless 0 <= first < last <=
/// limits::kMaxLayers.
absl::StatusOr<LayerRange> FromProto(const v1::LayerRange& proto);

/// Converts an object section to its message and back.
absl::Status ToProto(const ObjectSection& section, v1::ObjectSection* proto);
absl::StatusOr<ObjectSection> FromProto(const v1::ObjectSection& proto);

/// Converts a sliced layer to its message and back.
absl::Status ToProto(const SlicedLayer& layer, v1::SlicedLayer* proto);
absl::StatusOr<SlicedLayer> FromProto(const v1::SlicedLayer& proto);

/// Converts a walled island to its message and back.
absl::Status ToProto(const WalledIsland& island, v1::WalledIsland* proto);
absl::StatusOr<WalledIsland> FromProto(const v1::WalledIsland& proto);

/// Converts a walled section to its message and back.
absl::Status ToProto(const WalledSection& section, v1::WalledSection* proto);
absl::StatusOr<WalledSection> FromProto(const v1::WalledSection& proto);

/// Converts a walled layer to its message and back.
absl::Status ToProto(const WalledLayer& layer, v1::WalledLayer* proto);
absl::StatusOr<WalledLayer> FromProto(const v1::WalledLayer& proto);

/// Converts a fill group to its message and back.
absl::Status ToProto(const FillGroup& group, v1::FillGroup* proto);
absl::StatusOr<FillGroup> FromProto(const v1::FillGroup& proto);

/// Converts a filled island to its message and back.
absl::Status ToProto(const FilledIsland& island, v1::FilledIsland* proto);
absl::StatusOr<FilledIsland> FromProto(const v1::FilledIsland& proto);

/// Converts a filled section to its message and back.
absl::Status ToProto(const FilledSection& section, v1::FilledSection* proto);
absl::StatusOr<FilledSection> FromProto(const v1::FilledSection& proto);

/// Converts a filled layer to its message and back.
absl::Status ToProto(const FilledLayer& layer, v1::FilledLayer* proto);
absl::StatusOr<FilledLayer> FromProto(const v1::FilledLayer& proto);

/// Converts a travel to its message and back.
absl::Status ToProto(const Travel& travel, v1::Travel* proto);
absl::StatusOr<Travel> FromProto(const v1::Travel& proto);

/// Converts a spiral turn to its message and back.
absl::Status ToProto(const SpiralTurn& turn, v1::SpiralTurn* proto);
SpiralTurn FromProto(const v1::SpiralTurn& proto);

/// Converts a path block to its message and back.
absl::Status ToProto(const PathBlock& block, v1::PathBlock* proto);
absl::StatusOr<PathBlock> FromProto(const v1::PathBlock& proto);

/// Converts a block visit to its message and back.
absl::Status ToProto(const BlockVisit& visit, v1::BlockVisit* proto);
absl::StatusOr<BlockVisit> FromProto(const v1::BlockVisit& proto);

/// Converts an ordered layer to its message and back.
absl::Status ToProto(const OrderedLayer& layer, v1::OrderedLayer* proto);
absl::StatusOr<OrderedLayer> FromProto(const v1::OrderedLayer& proto);

/// Returns the range from the first to the last of the layers. REQUIRES: CheckConsecutive returns
/// OK for the layers.
template <typename Layers>
LayerRange RangeOf(const Layers& layers) {
  if (layers.empty()) return {};
  return {layers.front().frame.index, layers.back().frame.index + 1};
}

/// Appends a converted layer. Errors: the error of the conversion; REQUEST_MALFORMED if the layer
/// does not follow the previous one. The check at each layer stops a peer that sends layers without
/// end.
template <typename Layer>
absl::Status AppendNext(absl::StatusOr<Layer> layer, std::vector<Layer>* layers) {
  if (!layer.ok()) return layer.status();
  layers->push_back(*std::move(layer));
  const auto count = static_cast<int32_t>(layers->size());
  if (layers->back().frame.index == layers->front().frame.index + count - 1) {
    return absl::OkStatus();
  }
  return Malformed("layer", "does not follow the one before");
}

/// Checks that the index of each layer is one more than the index of the layer before.
template <typename Layers>
absl::Status CheckConsecutive(const Layers& layers) {
  for (size_t i = 1; i < layers.size(); ++i) {
    if (layers[i].frame.index != layers[i - 1].frame.index + 1) {
      return Malformed("layer", "does not follow the one before");
    }
  }
  return absl::OkStatus();
}

/// Checks that there is one layer for each index of the range, in order.
template <typename Layers>
absl::Status CheckLayersOfRange(const Layers& layers, LayerRange range) {
  if (absl::Status status = CheckConsecutive(layers); !status.ok()) return status;
  if (RangeOf(layers) == range) return absl::OkStatus();
  return Malformed("layer", "not one for each layer of the range");
}

/// Checks that each layer of the range has at least one program, and that the programs are sorted
/// by layer, then by pass.
template <typename Programs>
absl::Status CheckProgramsOfRange(const Programs& programs, LayerRange range) {
  int32_t next = range.first;
  for (size_t i = 0; i < programs.size(); ++i) {
    const int32_t index = programs[i].frame.index;
    const bool same_layer =
        i > 0 && index == programs[i - 1].frame.index && programs[i].pass > programs[i - 1].pass;
    if (index != next && !same_layer) return Malformed("layer", "does not follow the one before");
    if (!same_layer) ++next;
  }
  if (next == range.last) return absl::OkStatus();
  return Malformed("layer", "not a program for each layer of the range");
}

/// Checks the layers that a stage receives for a range: they are consecutive and contain the range.
absl::Status CheckNeighbourhood(std::span<const SlicedLayer> layers, LayerRange range);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
