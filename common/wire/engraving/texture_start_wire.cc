#include "common/wire/engraving/texture_start_wire.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const TextureStart& start, v1::TextureStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  proto->set_shared(start.shared);
  if (!start.range.empty()) *proto->mutable_range() = ToProto(start.range);
  return absl::OkStatus();
}

absl::StatusOr<TextureStart> FromProto(const v1::TextureStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  TextureStart start{*std::move(call), proto.shared()};
  if (proto.has_range()) {
    const absl::StatusOr<LayerRange> range = FromProto(proto.range());
    if (!range.ok()) return Within("range", range.status());
    start.range = *range;
  }
  return start;
}

}  // namespace slicefarm
