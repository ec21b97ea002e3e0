#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing {

/// Returns a project as bytes, for exchange between two programs of one build.
std::string EncodeProject(const Project& project);

/// Decodes untrusted bytes. Never allocates more memory than the size of `bytes` justifies. Errors:
/// InvalidArgument with the fault. For excessive or inconsistent contents, see FaultOf.
absl::StatusOr<Project> DecodeProject(std::string_view bytes);

}  // namespace slicefarm::slicing
