#pragma once

#include "absl/status/status.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Converts --texture, --mask, --anchor and --orient into settings of the job. If the texture is a
/// solid, also adds its model. Errors: REQUEST_MALFORMED for an image that cannot be read or is too
/// long for a setting, and for a machine that does not engrave.
absl::Status TakeTexture(JobOptions& options);

}  // namespace slicefarm::cli
