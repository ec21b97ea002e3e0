#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/beading.pb.h"
#include "slicefarm/v1/infill.pb.h"
#include "slicefarm/v1/motion.pb.h"
#include "slicefarm/v1/ordering.pb.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// What begins the stream of a call: who calls, with which options, and for the stages that look at
/// neighbours, about which layers. Errors: those of stage_call_wire.h, layer_wire.h and
/// settings_wire.h, with the way to the field.

template <typename Options>
struct LayersStart {
  StageCall call;
  Options options;
};
using OrderStart = LayersStart<OrderingOptions>;
using ProgramStart = LayersStart<MotionOptions>;

template <typename Options>
struct RangeStart : LayersStart<Options> {
  LayerRange range;
  int32_t layer_count = 0;
};
using BeadStart = RangeStart<BeadingOptions>;
using FillStart = RangeStart<InfillOptions>;

struct WorkStart {
  StageCall call;
  JobSettings settings;
  LayerRange range;
  int32_t layer_count = 0;
  std::vector<LayerPlan> plans;  ///< one for each layer of the range
};

void ToProto(const BeadStart& start, v1::BeadStart* proto);
absl::StatusOr<BeadStart> FromProto(const v1::BeadStart& proto);

void ToProto(const FillStart& start, v1::FillStart* proto);
absl::StatusOr<FillStart> FromProto(const v1::FillStart& proto);

void ToProto(const OrderStart& start, v1::OrderStart* proto);
absl::StatusOr<OrderStart> FromProto(const v1::OrderStart& proto);

void ToProto(const ProgramStart& start, v1::ProgramStart* proto);
absl::StatusOr<ProgramStart> FromProto(const v1::ProgramStart& proto);

absl::Status ToProto(const WorkStart& start, v1::WorkStart* proto);
absl::StatusOr<WorkStart> FromProto(const v1::WorkStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
