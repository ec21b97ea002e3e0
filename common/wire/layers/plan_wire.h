#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/job_facts.h"
#include "common/model/layers/job_plan.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/layer.pb.h"
#include "slicefarm/v1/planning.pb.h"

namespace slicefarm {

// Conversion of the input and the results of planning. Errors: see geometry_wire.h and
// path_wire.h, with the path to the field; REQUEST_MALFORMED for numbers that no job can have.

/// Checks the number of copies of a job. Errors: REQUEST_TOO_LARGE above limits::kMaxObjects, with
/// `field` in the message.
absl::Status CheckCopyCount(int count, std::string_view field);

/// Converts a copy to its message and back.
absl::Status ToProto(const Copy& copy, v1::Copy* proto);
absl::StatusOr<Copy> FromProto(const v1::Copy& proto);

/// Converts a placed copy to its message and back.
absl::Status ToProto(const PlacedCopy& copy, v1::PlacedCopy* proto);
absl::StatusOr<PlacedCopy> FromProto(const v1::PlacedCopy& proto);

/// Converts a section plan to its message and back.
absl::Status ToProto(const SectionPlan& plan, v1::SectionPlan* proto);
absl::StatusOr<SectionPlan> FromProto(const v1::SectionPlan& proto);

/// Converts the planned infill of a region to its message and back.
absl::Status ToProto(const PlannedInfill& plan, v1::PlannedInfill* proto);
absl::StatusOr<PlannedInfill> FromProto(const v1::PlannedInfill& proto);
/// Checks that the plans are sorted by stack, then by region settings. Errors: REQUEST_MALFORMED.
absl::Status CheckOrder(std::span<const PlannedInfill> plans);

/// Converts a layer plan to its message and back.
absl::Status ToProto(const LayerPlan& plan, v1::LayerPlan* proto);
absl::StatusOr<LayerPlan> FromProto(const v1::LayerPlan& proto);

/// Converts a stack without its sections, which are separate messages.
absl::Status ToProto(const AddedStack& added, v1::AddedStack* proto);
absl::StatusOr<AddedStack> FromProto(const v1::AddedStack& proto);
/// Checks that `lift_nm` is a valid height of a stack's bottom above the bed. Errors:
/// REQUEST_MALFORMED.
absl::Status CheckLift(std::string_view field, int64_t lift_nm);

/// Converts a skirt to its message and back.
absl::Status ToProto(const Skirt& skirt, v1::Skirt* proto);
absl::StatusOr<Skirt> FromProto(const v1::Skirt& proto);

/// Converts the quality of seams to its message and back.
v1::SeamQuality ToProto(const SeamQuality& quality);
absl::StatusOr<SeamQuality> FromProto(const v1::SeamQuality& proto);

/// Converts the facts of a pass to its message and back.
v1::PassFacts ToProto(const PassFacts& facts);
absl::StatusOr<PassFacts> FromProto(const v1::PassFacts& proto);

/// Converts the facts of a job to its message and back.
v1::JobFacts ToProto(const JobFacts& facts);
absl::StatusOr<JobFacts> FromProto(const v1::JobFacts& proto);

/// Converts a copy name to its message and back.
v1::CopyName ToProto(const CopyName& name);
absl::StatusOr<CopyName> FromProto(const v1::CopyName& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
