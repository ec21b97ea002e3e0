#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing {

/// A project as bytes between two programs of one build.
std::string EncodeProject(const Project& project);

/// The project of such bytes, which may be anything: nothing is allocated by a count that they do
/// not bear out. Errors: InvalidArgument that says what is wrong; for what is too much or does not
/// fit together, see CheckProject.
absl::StatusOr<Project> DecodeProject(std::string_view bytes);

}  // namespace slicefarm::slicing
