#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::lab {

/// Reads a model for milling. The numbers in the file are taken as mm. Errors: any error of the
/// reader of the file's format.
absl::StatusOr<milling::TriangleMesh> ReadTriangles(const std::string& path);

}  // namespace slicefarm::lab
