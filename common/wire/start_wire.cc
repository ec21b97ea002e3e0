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
namespace {

template <typename Start, typename Proto>
absl::Status PutCall(const Start& start, Proto* proto) {
  *proto->mutable_call() = ToProto(start.call);
  proto->set_shared(start.shared);
  return absl::OkStatus();
}

template <typename Start, typename Proto>
absl::StatusOr<Start> TakeCall(const Proto& proto) {
  Start start;
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  start.call = *std::move(call);
  start.shared = proto.shared();
  return start;
}

template <typename Start, typename Proto>
absl::Status PutRangeCall(const Start& start, Proto* proto) {
  *proto->mutable_range() = ToProto(start.range);
  return PutCall(start, proto);
}

template <typename Start, typename Proto>
absl::StatusOr<Start> TakeRangeCall(const Proto& proto) {
  absl::StatusOr<Start> start = TakeCall<Start>(proto);
  if (!start.ok()) return start;
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  start->range = *range;
  return start;
}

}  // namespace

absl::Status ToProto(const BeadStart& start, v1::BeadStart* proto) {
  return PutRangeCall(start, proto);
}
absl::StatusOr<BeadStart> FromProto(const v1::BeadStart& proto) {
  return TakeRangeCall<BeadStart>(proto);
}

absl::Status ToProto(const FillStart& start, v1::FillStart* proto) {
  return PutRangeCall(start, proto);
}
absl::StatusOr<FillStart> FromProto(const v1::FillStart& proto) {
  return TakeRangeCall<FillStart>(proto);
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

absl::Status ToProto(const OrderStart& start, v1::OrderStart* proto) {
  return PutCall(start, proto);
}
absl::StatusOr<OrderStart> FromProto(const v1::OrderStart& proto) {
  return TakeCall<OrderStart>(proto);
}

absl::Status ToProto(const ProgramStart& start, v1::ProgramStart* proto) {
  return PutCall(start, proto);
}
absl::StatusOr<ProgramStart> FromProto(const v1::ProgramStart& proto) {
  return TakeCall<ProgramStart>(proto);
}

absl::Status ToProto(const ExposeStart& start, v1::ExposeStart* proto) {
  return PutRangeCall(start, proto);
}
absl::StatusOr<ExposeStart> FromProto(const v1::ExposeStart& proto) {
  return TakeRangeCall<ExposeStart>(proto);
}

}  // namespace slicefarm
