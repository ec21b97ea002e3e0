#pragma once

#include "absl/status/statusor.h"
#include "common/model/options/planning_options.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

/// The planning stage's options, by the rules of settings_wire.h.
absl::Status ToProto(const PlanningOptions& options, v1::PlanningOptions* proto);
absl::StatusOr<PlanningOptions> FromProto(const v1::PlanningOptions& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
