#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace slicefarm::cli {

/// The end of an output's name tells its content. A neutral name such as `part.tmp` or `-` fits any
/// content.

/// Returns REQUEST_MALFORMED for a name that no content of the process has: the name of a model, of
/// a document, or of another process's files.
absl::Status CheckEnding(const std::string& output, Process process);

/// Returns REQUEST_MALFORMED if the name belongs to another format of the process than the job
/// makes. `settings_text`: ResolvedSettings::effective_text.
absl::Status CheckFormat(const std::string& output, Process process,
                         std::string_view settings_text);

/// Returns the setting that makes files of `format` (`--format`). The format is the ending of their
/// names without its dot. Errors: REQUEST_MALFORMED with the known formats.
absl::StatusOr<config::Setting> FormatSetting(const std::string& format, Process process);

}  // namespace slicefarm::cli
