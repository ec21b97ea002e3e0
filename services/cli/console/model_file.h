#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::cli {

/// Returns the name of a model file without its folders; "stdin" for `-`. The name is UTF-8 without
/// control characters, because messages and comments of the G-code contain it. A line end in a
/// comment would begin a new command.
std::string NameOf(const std::string& path);

/// Reads the bytes of a model file. Errors: REQUEST_MALFORMED with the file's name if it cannot be
/// read; MESH_TOO_LARGE above limits::kMaxMeshBytes.
absl::StatusOr<MeshFile> ReadModelFile(const std::string& path);

}  // namespace slicefarm::cli
