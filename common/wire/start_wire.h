#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "common/model/options/planning_options.h"
#include "common/stage/beading_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/beading.pb.h"
#include "slicefarm/v1/exposure.pb.h"
#include "slicefarm/v1/infill.pb.h"
#include "slicefarm/v1/motion.pb.h"
#include "slicefarm/v1/ordering.pb.h"
#include "slicefarm/v1/planning.pb.h"

namespace slicefarm {

/// First message of a call: the caller, the options and, for stages that look at
/// neighbours, the layers. Errors: those of stage_call_wire.h, layer_wire.h, plan_wire.h
/// and options_wire.h, with the path to the field.

/// `shared`: the digest of what the stage is told of the whole job (shared_wire.h), here a table of
/// options by region.
template <typename Table>
struct RangeStart {
  StageCall call;
  std::string shared;
  LayerRange range;
};
using BeadStart = RangeStart<BeadingTable>;
using FillStart = RangeStart<InfillTable>;

struct PlanStart {
  StageCall call;
  PlanningOptions options;
  std::vector<PlacedCopy> copies;
  std::vector<std::string> object_names;  ///< by object, for messages
};

struct OrderStart {
  StageCall call;
  std::string shared;  ///< of an OrderingJob
};

struct ProgramStart {
  StageCall call;
  std::string shared;  ///< of a MotionJob
};

struct ExposeStart {
  StageCall call;
  std::string shared;  ///< of an ExposureJob
  LayerRange range;
};

absl::Status ToProto(const BeadStart& start, v1::BeadStart* proto);
absl::StatusOr<BeadStart> FromProto(const v1::BeadStart& proto);

absl::Status ToProto(const FillStart& start, v1::FillStart* proto);
absl::StatusOr<FillStart> FromProto(const v1::FillStart& proto);

absl::Status ToProto(const PlanStart& start, v1::PlanStart* proto);
absl::StatusOr<PlanStart> FromProto(const v1::PlanStart& proto);

absl::Status ToProto(const OrderStart& start, v1::OrderStart* proto);
absl::StatusOr<OrderStart> FromProto(const v1::OrderStart& proto);

absl::Status ToProto(const ProgramStart& start, v1::ProgramStart* proto);
absl::StatusOr<ProgramStart> FromProto(const v1::ProgramStart& proto);

absl::Status ToProto(const ExposeStart& start, v1::ExposeStart* proto);
absl::StatusOr<ExposeStart> FromProto(const v1::ExposeStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
