#include "common/wire/start_wire.h"

#include <iterator>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/object_names.h"
#include "common/wire/support/repeated_wire.h"

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

absl::Status ToProto(const PlanStart& start, v1::PlanStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  proto->set_options(PackFields(start.options));
  proto->mutable_object_names()->Assign(start.object_names.begin(), start.object_names.end());
  return AllToProto(start.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<PlanStart> FromProto(const v1::PlanStart& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  status.Update(CheckObjectNames(proto.object_names()));
  if (!status.ok()) return status;
  PlanStart start;
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  start.call = *std::move(call);
  auto options = OptionsFromBytes<PlanningOptions>(proto.options());
  if (!options.ok()) return Within("options", options.status());
  start.options = *std::move(options);
  start.object_names.assign(proto.object_names().begin(), proto.object_names().end());
  status = AllFromProto(proto.copies(), "copies", &start.copies);
  if (!status.ok()) return status;
  return start;
}

}  // namespace slicefarm
