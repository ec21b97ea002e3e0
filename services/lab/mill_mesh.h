#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::lab {

/// A model as the mill sees it, in the file's own numbers as mm. Errors: those of reading it.
absl::StatusOr<milling::TriangleMesh> ReadTriangles(const std::string& path);

}  // namespace slicefarm::lab
