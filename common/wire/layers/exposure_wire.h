#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "processes/laser/model/exposed_program.h"
#include "slicefarm/v1/exposure.pb.h"

namespace slicefarm {

/// Programs of exposure and the texts around them. Texts are moved, not copied. Errors:
/// OUT_OF_RANGE, REQUEST_MALFORMED, REQUEST_TOO_LARGE naming the field.

/// Converts the report of an exposure to its message and back.
absl::Status ToProto(const ExposureReport& report, v1::ExposureReport* proto);
absl::StatusOr<ExposureReport> FromProto(const v1::ExposureReport& proto);

/// Converts an exposed program to its message and back.
absl::Status ToProto(ExposedProgram program, v1::ExposedProgram* proto);
absl::StatusOr<ExposedProgram> FromProto(v1::ExposedProgram proto);

/// Converts all of ExposureFrameRequest except its call and settings.
absl::Status ToProto(const ExposureSummary& summary, v1::ExposureFrameRequest* proto);
absl::StatusOr<ExposureSummary> FromProto(const v1::ExposureFrameRequest& proto);

/// Converts the texts around an exposure program to its message and back.
v1::ExposureFrame ToProto(ExposureEnvelope frame);
absl::StatusOr<ExposureEnvelope> FromProto(v1::ExposureFrame proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
