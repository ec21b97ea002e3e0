#include "common/wire/milling/mill_start_wire.h"

#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const StageCall& call, const MillInput& input, StepRange range,
                     v1::MillStart* proto) {
  *proto->mutable_call() = ToProto(call);
  if (range.size() > 0) *proto->mutable_range() = ToProto(range);
  return ToProto(input, proto->mutable_head());
}

absl::StatusOr<MillStartHead> FromProto(const v1::MillStart& proto) {
  absl::StatusOr<StageCall> call = FromProto(proto.call());
  if (!call.ok()) return call.status();
  absl::StatusOr<MillInputReader> input = MillInputReader::Begin(proto.head());
  if (!input.ok()) return Within("head", input.status());
  StepRange range;
  if (proto.has_range()) {
    const absl::StatusOr<StepRange> given = FromProto(proto.range());
    if (!given.ok()) return given.status();
    range = *given;
  }
  if (proto.step_count() < 0 || proto.step_count() > limits::kMaxMillSteps)
    return Malformed("step_count", "is no number of steps");
  return MillStartHead{*std::move(call), *std::move(input), range, proto.step_count(),
                       proto.settings_text()};
}

}  // namespace slicefarm
