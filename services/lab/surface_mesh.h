#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::lab {

/// Reads a model as a surface. The numbers in the file are taken as mm. The vertices of an OBJ file
/// keep their indices, so that other programs can match them. Errors: any error of the reader of
/// the file's format.
absl::StatusOr<texture::SurfaceMesh> ReadSurface(const std::string& path);

}  // namespace slicefarm::lab
