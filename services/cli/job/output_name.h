#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace slicefarm::cli {

/// What the end of an output's name says of its content. A name that says nothing, such as
/// `part.tmp` or `-`, fits any content.

/// Returns REQUEST_MALFORMED for a name that no content of the process has: one of a model, of a
/// document, of another process's files.
absl::Status CheckEnding(const std::string& output, Process process);

/// Returns REQUEST_MALFORMED if the name is that of another format of the process than the job
/// makes. `settings_text`: ResolvedSettings::effective_text.
absl::Status CheckFormat(const std::string& output, Process process,
                         std::string_view settings_text);

/// Returns the setting that makes files of `format` (`--format`), which is the ending of their
/// names without its dot. Errors: REQUEST_MALFORMED, naming those that there are.
absl::StatusOr<config::Setting> FormatSetting(const std::string& format, Process process);

}  // namespace slicefarm::cli
