#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "processes/laser/model/exposed_program.h"
#include "slicefarm/v1/exposure.pb.h"

namespace slicefarm {

// Conversion of exposure programs and of the texts before and after them. Texts are moved, not
// copied. Errors, with the name of the field: OUT_OF_RANGE, REQUEST_MALFORMED, REQUEST_TOO_LARGE.

/// Converts the report of an exposure to its message and back.
absl::Status ToProto(const ExposureReport& report, v1::ExposureReport* proto);
absl::StatusOr<ExposureReport> FromProto(const v1::ExposureReport& proto);

/// Converts an exposed program to its message and back.
absl::Status ToProto(ExposedProgram program, v1::ExposedProgram* proto);
absl::StatusOr<ExposedProgram> FromProto(v1::ExposedProgram proto);

/// Converts a summary to all fields of ExposureEnvelopeRequest except `call` and the settings, and
/// back.
absl::Status ToProto(const ExposureSummary& summary, v1::ExposureEnvelopeRequest* proto);
absl::StatusOr<ExposureSummary> FromProto(const v1::ExposureEnvelopeRequest& proto);

/// Converts the texts before and after an exposure program to their message and back.
v1::ExposureEnvelope ToProto(ExposureEnvelope envelope);
absl::StatusOr<ExposureEnvelope> FromProto(v1::ExposureEnvelope proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
