#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"

namespace slicefarm::slicing {

/// Returns true if `bytes` start like a ZIP archive.
bool LooksLike3mf(std::string_view bytes);

/// Reads a 3MF file: the core specification and the production extension, with the additional files
/// of PrusaSlicer, Bambu Studio and OrcaSlicer. Sources: 3MF Consortium, Core Specification 1.3,
/// Production Extension 1.1; files written by the slicers. Arguments and errors: see ReadMeshFile.
absl::StatusOr<MeshFileContents> Read3mf(std::string_view bytes, double coordinate_limit,
                                         ReadDepth depth, const CancelToken& cancel);

}  // namespace slicefarm::slicing
