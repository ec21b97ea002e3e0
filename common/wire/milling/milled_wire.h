#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "processes/mill/model/milled_program.h"
#include "processes/mill/model/milled_step.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

// Conversion of the results of milling. Errors, with the name of the field: OUT_OF_RANGE,
// REQUEST_MALFORMED, REQUEST_TOO_LARGE.

/// Converts a milled step to its message and back.
absl::Status ToProto(const MilledStep& step, v1::MilledStep* proto);
absl::StatusOr<MilledStep> FromProto(const v1::MilledStep& proto);

/// Converts a mill layout to its message and back.
absl::Status ToProto(const MillLayout& layout, v1::MillLayout* proto);
absl::StatusOr<MillLayout> FromProto(const v1::MillLayout& proto);

/// Converts the report of a milling job to its message and back.
absl::Status ToProto(const MillReport& report, v1::MillReport* proto);
absl::StatusOr<MillReport> FromProto(const v1::MillReport& proto);

/// Converts a step range to its message and back.
v1::StepRange ToProto(StepRange range);
/// Converts a range of steps. Errors: REQUEST_MALFORMED for an empty range, and for a range that no
/// job can have.
absl::StatusOr<StepRange> FromProto(const v1::StepRange& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
