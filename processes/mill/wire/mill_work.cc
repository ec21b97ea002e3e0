#include "processes/mill/wire/mill_work.h"

#include "common/wire/milling/milled_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const MillTask& task, v1::MillWork* proto) {
  *proto->mutable_range() = ToProto(task.steps);
  proto->set_phase(EnumToProto<v1::MillPhase>(task.phase));
  proto->set_phase_first(task.phase_first);
  proto->set_weight(task.weight);
  return absl::OkStatus();
}

absl::StatusOr<MillTask> FromProto(const v1::MillWork& proto) {
  const absl::StatusOr<StepRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  const auto phase = EnumFromProto<MillPhase>(proto.phase(), kMillPhaseCount, "phase");
  if (!phase.ok()) return phase.status();
  if (proto.phase_first() < 0 || proto.phase_first() > range->first)
    return Malformed("phase_first", "is no step before the range");
  if (proto.weight() < 0) return Malformed("weight", "is negative");
  return MillTask{*range, *phase, proto.phase_first(), proto.weight(), {}};
}

}  // namespace slicefarm
