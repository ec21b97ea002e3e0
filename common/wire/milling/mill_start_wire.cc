#include "common/wire/milling/mill_start_wire.h"

#include <utility>

#include "common/model/limits.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const MillStart& start, v1::MillStart* proto) {
  *proto->mutable_call() = ToProto(start.call);
  proto->set_shared(start.shared);
  if (start.range.size() > 0) *proto->mutable_range() = ToProto(start.range);
  proto->set_step_count(start.step_count);
  proto->set_settings_text(start.settings_text);
  return absl::OkStatus();
}

absl::StatusOr<MillStart> FromProto(const v1::MillStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  MillStart start{*std::move(call), proto.shared()};
  if (proto.has_range()) {
    const absl::StatusOr<StepRange> range = FromProto(proto.range());
    if (!range.ok()) return range.status();
    start.range = *range;
  }
  if (proto.step_count() < 0 || proto.step_count() > limits::kMaxMillSteps)
    return Malformed("step_count", "is no number of steps");
  start.step_count = proto.step_count();
  start.settings_text = proto.settings_text();
  return start;
}

}  // namespace slicefarm
