#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Ending of an archive with G-code, which may contain several plates.
inline constexpr std::string_view kArchiveEnding = ".gcode.3mf";

/// Returns the file of one plate: the path itself, or with --plates the path with the number of the
/// plate before its ending, such as `out-2.gcode`.
std::string OutputOf(const JobOptions& options, const std::string& path, size_t plate);

/// Puts the archives of the plates 0 to `plates` - 1 (OutputOf) into the archive `output` and
/// removes them. Does nothing for other files, and without --plates. Errors: see ReadFile and
/// WriteFile; REQUEST_MALFORMED if a file is not an archive of slicefarm.
absl::Status JoinPlates(const JobOptions& options, const std::string& output, size_t plates);

}  // namespace slicefarm::cli
