#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/engrave_job.h"

namespace slicefarm::texture {

/// Returns the bytes of a file that is made in one piece: the surface with the texture on it, or a
/// picture. REQUIRES: IsWhole(job.format). Errors: the errors of DisplacedMesh and of LayerPaths;
/// Internal if a picture cannot be made; Cancelled. Cost: the cost of all layers for the lines.
absl::StatusOr<std::string> WholeFile(const EngraveJob& job, const CancelToken& cancel = {});

}  // namespace slicefarm::texture
