#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/engrave_job.h"

namespace slicefarm::texture {

/// Returns the bytes of a file that is made at once: the surface with the texture in it, or a
/// picture. REQUIRES: IsWhole(job.format). Errors: those of DisplacedMesh and of LayerPaths;
/// Internal if a picture cannot be made; Cancelled. Cost: that of all layers for the lines.
absl::StatusOr<std::string> WholeFile(const EngraveJob& job, const CancelToken& cancel = {});

}  // namespace slicefarm::texture
