#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/options/motion_options.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

/// The motion stage's options, by the rules of settings_wire.h.
absl::Status ToProto(const MotionOptions& options, v1::MotionOptions* proto);
absl::StatusOr<MotionOptions> FromProto(const v1::MotionOptions& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
