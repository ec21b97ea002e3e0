#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace slicefarm::cli {

// Checks of output names. The ending of a name determines the kind of file. A neutral name such as
// `part.tmp` or `-` is accepted for any kind.

/// Checks that the process can make a file with this name. Errors: REQUEST_MALFORMED for the ending
/// of a model, of a document, or of another process's files.
absl::Status CheckEnding(const std::string& output, Process process);

/// Checks that the ending of the name belongs to an output format of the job. `settings_text`:
/// ResolvedSettings::effective_text. Errors: REQUEST_MALFORMED if it belongs to another format of
/// the process.
absl::Status CheckFormat(const std::string& output, Process process,
                         std::string_view settings_text);

/// Returns the settings that select the output format (`--format`): the setting of the format, and
/// the default values of the settings of other formats. `format`: the ending of the format's files
/// without its dot. Errors: REQUEST_MALFORMED with the known formats.
absl::StatusOr<std::vector<config::Setting>> FormatSettings(const std::string& format,
                                                            Process process);

}  // namespace slicefarm::cli
