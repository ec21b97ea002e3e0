#include "processes/mill/wire/mill_work.h"

#include "common/wire/milling/milled_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const MillWork& work, v1::MillWork* proto) {
  *proto->mutable_range() = ToProto(work.steps);
  proto->set_phase(EnumToProto<v1::MillPhase>(work.phase));
  proto->set_phase_first(work.phase_first);
  proto->set_weight(work.weight);
  proto->set_shared(work.shared);
  return absl::OkStatus();
}

absl::StatusOr<MillWork> FromProto(const v1::MillWork& proto) {
  const absl::StatusOr<StepRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  const auto phase = EnumFromProto<MillPhase>(proto.phase(), kMillPhaseCount, "phase");
  if (!phase.ok()) return phase.status();
  if (proto.phase_first() < 0 || proto.phase_first() > range->first)
    return Malformed("phase_first", "is no step before the range");
  if (proto.weight() < 0) return Malformed("weight", "is negative");
  return MillWork{*range, *phase, proto.phase_first(), proto.weight(), proto.shared()};
}

}  // namespace slicefarm
