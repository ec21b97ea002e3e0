#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing {

/// Returns a project as bytes, for exchange between two programs of the same build.
std::string EncodeProject(const Project& project);

/// Decodes untrusted bytes. Allocates memory only in proportion to the size of `bytes`. Errors:
/// InvalidArgument with the fault. Call FaultOf to find excessive or inconsistent contents.
absl::StatusOr<Project> DecodeProject(std::string_view bytes);

}  // namespace slicefarm::slicing
