#include "processes/laser/wire/laser_work.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/exposure_options_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const LaserWork& work, v1::LaserWork* proto) {
  *proto->mutable_settings() = ToProto(work.settings);
  *proto->mutable_range() = ToProto(work.range);
  return AllToProto(work.copies, "copies", proto->mutable_copies());
}

absl::StatusOr<LaserWork> FromProto(const v1::LaserWork& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (!status.ok()) return status;
  absl::StatusOr<ExposureSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  LaserWork work{*std::move(settings), *range, {}};
  status = AllFromProto(proto.copies(), "copies", &work.copies);
  if (!status.ok()) return status;
  return work;
}

}  // namespace slicefarm
