#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::cli {

/// Returns the name of a model file without its folders; "stdin" for `-`. The name is UTF-8 without
/// control characters, because it is sent over the wire and written into comments. A line end in a
/// comment would begin a command.
std::string NameOf(const std::string& path);

/// Reads the bytes of a model file. Errors: REQUEST_MALFORMED naming the file; MESH_TOO_LARGE.
absl::StatusOr<MeshFile> ReadModelFile(const std::string& path);

}  // namespace slicefarm::cli
