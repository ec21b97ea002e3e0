#pragma once

#include "absl/status/status.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Converts --texture, --mask, --anchor and --orient into settings of the job. If the texture is
/// the file of a solid, also adds this file as a model of the job. Errors: REQUEST_MALFORMED for an
/// image that cannot be read or is too long for a setting, and for a machine that does not engrave.
absl::Status TakeTexture(JobOptions& options);

}  // namespace slicefarm::cli
