#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::lab {

/// A model as a surface, in the file's own numbers as mm. An OBJ file's vertices keep their
/// numbers, so that its other readers find their own again. Errors: those of reading it.
absl::StatusOr<texture::SurfaceMesh> ReadSurface(const std::string& path);

}  // namespace slicefarm::lab
