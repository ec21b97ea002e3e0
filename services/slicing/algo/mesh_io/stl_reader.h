#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// STL in both flavours. Normals and attributes are not looked at: the order of the corners tells
/// the outside. Source: 3D Systems, StereoLithography Interface Specification, 1989. Arguments and
/// errors: see ReadMesh.

/// Whether the length of `bytes` is 84 + 50 n, n being the count at offset 80.
bool IsBinaryStl(std::string_view bytes);

/// Whether `bytes` start like an ASCII STL.
bool LooksLikeAsciiStl(std::string_view bytes);

absl::StatusOr<RawMesh> ReadBinaryStl(std::string_view bytes, double coordinate_limit,
                                      const CancelToken& cancel);

/// Keywords in any case; text between the statements that is not a statement is an error.
absl::StatusOr<RawMesh> ReadAsciiStl(std::string_view bytes, double coordinate_limit,
                                     const CancelToken& cancel);

}  // namespace slicefarm::slicing
