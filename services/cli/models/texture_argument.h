#pragma once

#include "absl/status/status.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Turns --texture, --mask, --anchor and --orient into what a job is told: settings, and a model
/// more if the texture is a solid. Errors: REQUEST_MALFORMED for an image that cannot be read or is
/// too long for a setting, and where the machine does not engrave.
absl::Status TakeTexture(JobOptions& options);

}  // namespace slicefarm::cli
