#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/job_plan.h"
#include "common/model/layer.h"
#include "common/model/options/exposure_settings.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// LaserTask but its outlines.
struct LaserWork {
  ExposureSettings settings;
  LayerRange range;
  std::vector<Copy> copies;
};

/// Errors: REQUEST_MALFORMED and REQUEST_TOO_LARGE with the way to the field.
absl::Status ToProto(const LaserWork& work, v1::LaserWork* proto);
absl::StatusOr<LaserWork> FromProto(const v1::LaserWork& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
