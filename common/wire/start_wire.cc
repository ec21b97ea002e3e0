#include "common/wire/start_wire.h"

#include <utility>

#include "common/wire/layer_wire.h"
#include "common/wire/motion_options_wire.h"
#include "common/wire/repeated_wire.h"
#include "common/wire/settings_wire.h"
#include "common/wire/stage_call_wire.h"

namespace slicefarm {
namespace {

template <typename Options, typename Proto>
void PutStart(const LayersStart<Options>& start, Proto* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_options() = ToProto(start.options);
}

template <typename Options, typename Proto>
absl::StatusOr<LayersStart<Options>> TakeStart(const Proto& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  absl::StatusOr<Options> options = FromProto(proto.options());
  if (!options.ok()) return Within("options", options.status());
  return LayersStart<Options>{*std::move(call), *std::move(options)};
}

template <typename Options, typename Proto>
void PutRangeStart(const RangeStart<Options>& start, Proto* proto) {
  PutStart(start, proto);
  *proto->mutable_range() = ToProto(start.range);
  proto->set_layer_count(start.layer_count);
}

template <typename Options, typename Proto>
absl::StatusOr<RangeStart<Options>> TakeRangeStart(const Proto& proto) {
  absl::StatusOr<LayersStart<Options>> start = TakeStart<Options>(proto);
  if (!start.ok()) return start.status();
  const absl::StatusOr<LayerRange> range = FromProto(proto.range(), proto.layer_count());
  if (!range.ok()) return range.status();
  return RangeStart<Options>{*std::move(start), *range, proto.layer_count()};
}

}  // namespace

void ToProto(const BeadStart& start, v1::BeadStart* proto) { PutRangeStart(start, proto); }
absl::StatusOr<BeadStart> FromProto(const v1::BeadStart& proto) {
  return TakeRangeStart<BeadingOptions>(proto);
}

void ToProto(const FillStart& start, v1::FillStart* proto) { PutRangeStart(start, proto); }
absl::StatusOr<FillStart> FromProto(const v1::FillStart& proto) {
  return TakeRangeStart<InfillOptions>(proto);
}

void ToProto(const OrderStart& start, v1::OrderStart* proto) { PutStart(start, proto); }
absl::StatusOr<OrderStart> FromProto(const v1::OrderStart& proto) {
  return TakeStart<OrderingOptions>(proto);
}

void ToProto(const ProgramStart& start, v1::ProgramStart* proto) { PutStart(start, proto); }
absl::StatusOr<ProgramStart> FromProto(const v1::ProgramStart& proto) {
  return TakeStart<MotionOptions>(proto);
}

absl::Status ToProto(const WorkStart& start, v1::WorkStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_range() = ToProto(start.range);
  proto->set_layer_count(start.layer_count);
  absl::Status status = ToProto(start.settings, proto->mutable_settings());
  if (!status.ok()) return Within("settings", status);
  return AllToProto(start.plans, "plans", proto->mutable_plans());
}

absl::StatusOr<WorkStart> FromProto(const v1::WorkStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  absl::StatusOr<JobSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<LayerRange> range = FromProto(proto.range(), proto.layer_count());
  if (!range.ok()) return range.status();
  WorkStart start{*std::move(call), *std::move(settings), *range, proto.layer_count(), {}};
  if (proto.plans_size() != range->size()) {
    return Malformed("plans", "not one for each layer of the range");
  }
  if (absl::Status status = AllFromProto(proto.plans(), "plans", &start.plans); !status.ok()) {
    return status;
  }
  return start;
}

}  // namespace slicefarm
