#include "processes/fdm/wire/fdm_work.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const FdmWork& work, v1::FdmWork* proto) {
  *proto->mutable_range() = ToProto(work.range);
  *proto->mutable_facts() = ToProto(work.facts);
  absl::Status status = ToProto(work.settings, proto->mutable_settings());
  if (!status.ok()) return Within("settings", status);
  status.Update(AllToProto(work.plans, "plans", proto->mutable_plans()));
  status.Update(AllToProto(work.copies, "copies", proto->mutable_copies()));
  return status;
}

absl::StatusOr<FdmWork> FromProto(const v1::FdmWork& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (!status.ok()) return status;
  absl::StatusOr<FdmSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  absl::StatusOr<JobFacts> facts = FromProto(proto.facts());
  if (!facts.ok()) return Within("facts", facts.status());
  FdmWork work{*std::move(settings), *range, {}, {}, *std::move(facts)};
  if (proto.plans_size() != range->size())
    return Malformed("plans", "not one for each layer of the range");
  status = AllFromProto(proto.plans(), "plans", &work.plans);
  status.Update(AllFromProto(proto.copies(), "copies", &work.copies));
  if (!status.ok()) return status;
  return work;
}

}  // namespace slicefarm
