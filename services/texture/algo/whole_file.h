#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/engrave_job.h"

namespace slicefarm::texture {

/// Returns the bytes of a file that is not made layer by layer: the surface with the texture
/// applied, or a picture. REQUIRES: IsWhole(job.format). Errors: any error of DisplacedMesh and of
/// LayerPaths; Internal if a picture cannot be made; Cancelled. Cost: if the file shows lines, the
/// cost of all layers.
absl::StatusOr<std::string> WholeFile(const EngraveJob& job, const CancelToken& cancel = {});

}  // namespace slicefarm::texture
