#include "processes/laser/wire/laser_work.h"

#include "common/wire/layers/layer_wire.h"

namespace slicefarm {

absl::Status ToProto(const LaserWork& work, v1::LaserWork* proto) {
  *proto->mutable_range() = ToProto(work.range);
  proto->set_shared(work.shared);
  return absl::OkStatus();
}

absl::StatusOr<LaserWork> FromProto(const v1::LaserWork& proto) {
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  return LaserWork{*range, proto.shared()};
}

}  // namespace slicefarm
