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

/// What begins a call of the milling service. Errors: those of stage_call_wire.h;
/// REQUEST_MALFORMED naming the field.
struct MillStart {
  StageCall call;
  std::string shared;      ///< of a MillInput
  StepRange range = {};    ///< of MillSteps; empty: of none
  int32_t step_count = 0;  ///< of AssembleProgram: so many steps follow
  std::string settings_text = {};
};
absl::Status ToProto(const MillStart& start, v1::MillStart* proto);
absl::StatusOr<MillStart> FromProto(const v1::MillStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
