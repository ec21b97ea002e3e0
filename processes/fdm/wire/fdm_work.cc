#include "processes/fdm/wire/fdm_work.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"
#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm {

absl::Status ToProto(const FdmWork& work, v1::FdmWork* proto) {
  *proto->mutable_range() = ToProto(work.range);
  return AllToProto(work.plans, "plans", proto->mutable_plans());
}

absl::StatusOr<FdmWork> FromProto(const v1::FdmWork& proto) {
  const absl::StatusOr<LayerRange> range = FromProto(proto.range());
  if (!range.ok()) return range.status();
  FdmWork work{*range, {}};
  if (proto.plans_size() != range->size())
    return Malformed("plans", "not one for each layer of the range");
  const absl::Status status = AllFromProto(proto.plans(), "plans", &work.plans);
  if (!status.ok()) return status;
  return work;
}

absl::Status ToProto(const FdmShared& job, v1::FdmShared* proto) {
  *proto->mutable_facts() = ToProto(job.facts);
  proto->set_settings(PackFields(job.settings));
  return AllToProto(job.copies, "copies", proto->mutable_copies());
}

absl::StatusOr<FdmShared> FromProto(const v1::FdmShared& proto) {
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (!status.ok()) return status;
  auto settings = OptionsFromBytes<FdmSettings>(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<JobFacts> facts = FromProto(proto.facts());
  if (!facts.ok()) return Within("facts", facts.status());
  FdmShared job{*std::move(settings), {}, *std::move(facts)};
  status = AllFromProto(proto.copies(), "copies", &job.copies);
  if (!status.ok()) return status;
  return job;
}

}  // namespace slicefarm
