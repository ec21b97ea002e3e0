#include "common/wire/start_wire.h"

#include <iterator>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/exposure_options_wire.h"
#include "common/wire/options/motion_options_wire.h"
#include "common/wire/options/planning_options_wire.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/object_names.h"
#include "common/wire/support/repeated_wire.h"

namespace slicefarm {
namespace {

/// Call and options, which all starts but those of ranges have once.
template <typename Start, typename Proto>
absl::StatusOr<Start> TakeStart(const Proto& proto) {
  Start start;
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  start.call = *std::move(call);
  auto options = FromProto(proto.options());
  if (!options.ok()) return Within("options", options.status());
  start.options = *std::move(options);
  return start;
}

template <typename Start, typename Proto>
absl::Status PutRangeStart(const Start& start, Proto* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_range() = ToProto(start.range);
  for (const auto& options : start.options) *proto->add_options() = ToProto(options);
  return absl::OkStatus();
}

template <typename Start, typename Proto>
absl::StatusOr<Start> TakeRangeStart(const Proto& proto) {
  Start start;
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  start.call = *std::move(call);
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  start.range = *range;
  if (absl::Status rows = CheckRows(proto.options_size(), "options"); !rows.ok()) return rows;
  absl::Status status = AllFromProto(proto.options(), "options", &start.options);
  if (!status.ok()) return status;
  return start;
}

}  // namespace

absl::Status ToProto(const BeadStart& start, v1::BeadStart* proto) {
  return PutRangeStart(start, proto);
}
absl::StatusOr<BeadStart> FromProto(const v1::BeadStart& proto) {
  return TakeRangeStart<BeadStart>(proto);
}

absl::Status ToProto(const FillStart& start, v1::FillStart* proto) {
  return PutRangeStart(start, proto);
}
absl::StatusOr<FillStart> FromProto(const v1::FillStart& proto) {
  return TakeRangeStart<FillStart>(proto);
}

absl::Status ToProto(const PlanStart& start, v1::PlanStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  const absl::Status status = ToProto(start.options, proto->mutable_options());
  if (!status.ok()) return Within("options", status);
  proto->mutable_object_names()->Assign(start.object_names.begin(), start.object_names.end());
  return AllToProto(start.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<PlanStart> FromProto(const v1::PlanStart& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  status.Update(CheckObjectNames(proto.object_names()));
  if (!status.ok()) return status;
  absl::StatusOr<PlanStart> start = TakeStart<PlanStart>(proto);
  if (!start.ok()) return start;
  start->object_names.assign(proto.object_names().begin(), proto.object_names().end());
  status = AllFromProto(proto.copies(), "copies", &start->copies);
  if (!status.ok()) return status;
  return start;
}

absl::Status ToProto(const OrderStart& start, v1::OrderStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_options() = ToProto(start.options);
  return AllToProto(start.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<OrderStart> FromProto(const v1::OrderStart& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (!status.ok()) return status;
  absl::StatusOr<OrderStart> start = TakeStart<OrderStart>(proto);
  if (!start.ok()) return start;
  status = AllFromProto(proto.copies(), "copies", &start->copies);
  if (!status.ok()) return status;
  return start;
}

absl::Status ToProto(const ProgramStart& start, v1::ProgramStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_options() = ToProto(start.options);
  *proto->mutable_facts() = ToProto(start.facts);
  return absl::OkStatus();
}
absl::StatusOr<ProgramStart> FromProto(const v1::ProgramStart& proto) {
  absl::StatusOr<ProgramStart> start = TakeStart<ProgramStart>(proto);
  if (!start.ok()) return start;
  absl::StatusOr<JobFacts> facts = FromProto(proto.facts());
  if (!facts.ok()) return Within("facts", facts.status());
  start->facts = *std::move(facts);
  return start;
}

absl::Status ToProto(const ExposeStart& start, v1::ExposeStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  *proto->mutable_settings() = ToProto(start.settings);
  *proto->mutable_range() = ToProto(start.range);
  return AllToProto(start.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<ExposeStart> FromProto(const v1::ExposeStart& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (!status.ok()) return status;
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  absl::StatusOr<ExposureSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  ExposeStart start{*std::move(call), *std::move(settings), *range, {}};
  status = AllFromProto(proto.copies(), "copies", &start.copies);
  if (!status.ok()) return status;
  return start;
}

}  // namespace slicefarm
