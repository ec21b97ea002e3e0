#pragma once

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/stage/beading_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/start.pb.h"

namespace slicefarm {

// First message of a call of most stages. Errors: see stage_call_wire.h, layer_wire.h, plan_wire.h
// and options_check.h, with the path to the field.

/// Start of a call: context, job data and layers.
struct StageStart {
  StageCall call;
  std::string shared;     ///< digest of the stage's job data (shared_wire.h)
  LayerRange range = {};  ///< layers to work on; empty: the call is not about layers
};

absl::Status ToProto(const StageStart& start, v1::StageStart* proto);
absl::StatusOr<StageStart> FromProto(const v1::StageStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
