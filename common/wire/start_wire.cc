#include "common/wire/start_wire.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/stage_call_wire.h"

namespace slicefarm {

absl::Status ToProto(const StageStart& start, v1::StageStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  proto->set_shared(start.shared);
  if (!start.range.empty()) *proto->mutable_range() = ToProto(start.range);
  return absl::OkStatus();
}
absl::StatusOr<StageStart> FromProto(const v1::StageStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  StageStart start{*std::move(call), proto.shared()};
  if (!proto.has_range()) return start;
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  start.range = *range;
  return start;
}

}  // namespace slicefarm
