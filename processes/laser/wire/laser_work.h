#pragma once

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// LaserTask but its outlines.
struct LaserWork {
  LayerRange range;
  std::string shared;  ///< the digest of its ExposureJob
};

/// Errors: REQUEST_MALFORMED with the way to the field.
absl::Status ToProto(const LaserWork& work, v1::LaserWork* proto);
absl::StatusOr<LaserWork> FromProto(const v1::LaserWork& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
