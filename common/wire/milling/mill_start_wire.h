#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "processes/mill/model/milled_step.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

/// First message of a call of the milling service. Errors: see stage_call_wire.h; REQUEST_MALFORMED
/// with the name of the field.
struct MillStart {
  StageCall call;
  std::string shared;      ///< digest of the job's MillInput (shared_wire.h)
  StepRange range = {};    ///< steps of a MillSteps call; empty for other calls
  int32_t step_count = 0;  ///< number of steps that follow in an AssembleProgram call
  std::string settings_text = {};
};
absl::Status ToProto(const MillStart& start, v1::MillStart* proto);
absl::StatusOr<MillStart> FromProto(const v1::MillStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
