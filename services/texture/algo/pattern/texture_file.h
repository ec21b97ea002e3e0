#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/image_heights.h"
#include "services/texture/algo/pattern/texture.h"

namespace slicefarm::texture {

struct TextureFileOptions {
  ImageHeightOptions image = {};
  Eigen::Vector2d pitch_mm = Eigen::Vector2d::Zero();  ///< of a solid's repetitions; 0: its box's
};

/// A solid of binary STL, corners at exactly the same place welded. Errors: MESH_TRUNCATED,
/// MESH_TOO_LARGE.
absl::StatusOr<SurfaceMesh> ReadBinaryStl(std::string_view bytes);

/// A texture of a file's bytes: a PNG image, or a solid of binary STL. Errors: those of
/// ImageHeights, ReadBinaryStl and TextureOf.
absl::StatusOr<Texture> TextureOfFile(std::string_view bytes, const TextureFileOptions& options);

}  // namespace slicefarm::texture
