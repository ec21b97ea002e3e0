#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/stage/beading_stage.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/stages.h"
#include "common/wire/shared_wire.h"
#include "slicefarm/v1/beading.pb.h"
#include "slicefarm/v1/exposure.pb.h"
#include "slicefarm/v1/infill.pb.h"
#include "slicefarm/v1/motion.pb.h"
#include "slicefarm/v1/ordering.pb.h"

namespace slicefarm {

struct ExposureJob;
struct MotionJob;
struct OrderingJob;

// Conversion of job data that all calls of a stage share. Errors: see options_wire.h and
// plan_wire.h, with the path to the field.

/// Converts a beading table to its message and back.
absl::Status ToProto(const BeadingTable& table, v1::BeadingTable* proto);
absl::StatusOr<BeadingTable> FromProto(const v1::BeadingTable& proto);

/// Converts an infill table to its message and back.
absl::Status ToProto(const InfillTable& table, v1::InfillTable* proto);
absl::StatusOr<InfillTable> FromProto(const v1::InfillTable& proto);

/// Converts an ordering job to its message and back.
absl::Status ToProto(const OrderingJob& job, v1::OrderingJob* proto);
absl::StatusOr<OrderingJob> FromProto(const v1::OrderingJob& proto);

/// Converts a motion job to its message and back.
absl::Status ToProto(const MotionJob& job, v1::MotionJob* proto);
absl::StatusOr<MotionJob> FromProto(const v1::MotionJob& proto);

/// Converts an exposure job to its message and back.
absl::Status ToProto(const ExposureJob& job, v1::ExposureJob* proto);
absl::StatusOr<ExposureJob> FromProto(const v1::ExposureJob& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
using slicefarm::ToProto;
}  // namespace v1

template <>
struct MessageOf<BeadingTable> {
  using Type = v1::BeadingTable;
};
template <>
struct MessageOf<InfillTable> {
  using Type = v1::InfillTable;
};
template <>
struct MessageOf<OrderingJob> {
  using Type = v1::OrderingJob;
};
template <>
struct MessageOf<MotionJob> {
  using Type = v1::MotionJob;
};
template <>
struct MessageOf<ExposureJob> {
  using Type = v1::ExposureJob;
};

}  // namespace slicefarm
