#include "common/wire/plan_start_wire.h"

#include <utility>

#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/object_names.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

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
