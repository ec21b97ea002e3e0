#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"

namespace slicefarm::slicing {

/// Whether `bytes` start like an archive.
bool LooksLike3mf(std::string_view bytes);

/// 3MF: the core specification and the production extension, with what PrusaSlicer, Bambu Studio
/// and OrcaSlicer put beside them. Sources: 3MF Consortium, Core Specification 1.3, Production
/// Extension 1.1; the slicers' files themselves. Arguments and errors: see ReadMeshFile.
absl::StatusOr<MeshFileContents> Read3mf(std::string_view bytes, double coordinate_limit,
                                         ReadDepth depth, const CancelToken& cancel);

}  // namespace slicefarm::slicing
