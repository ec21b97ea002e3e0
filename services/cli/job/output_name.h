#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace slicefarm::cli {

// Checks of output names. The ending of a name determines the kind of file. A neutral name such as
// `part.tmp` or `-` is accepted for any kind.

/// Checks that the process can make a file with this name. Errors: REQUEST_MALFORMED for the ending
/// of a model, of a document, or of another process's files.
absl::Status CheckEnding(const std::string& output, Process process);

/// Checks that the ending of the name is the one of the job's output format. `settings_text`:
/// ResolvedSettings::effective_text. Errors: REQUEST_MALFORMED if it belongs to another format of
/// the process.
absl::Status CheckFormat(const std::string& output, Process process,
                         std::string_view settings_text);

/// Returns the setting that selects the output format (`--format`). `format`: the ending of the
/// format's files without its dot. Errors: REQUEST_MALFORMED with the known formats.
absl::StatusOr<config::Setting> FormatSetting(const std::string& format, Process process);

}  // namespace slicefarm::cli
