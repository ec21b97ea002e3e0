#pragma once

#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::slicing {

/// Function that reads all contents of a 3MF file except its triangles. It returns one job for each
/// plate with printable objects. The jobs identify the file by its SHA-256. Errors:
/// REQUEST_MALFORMED for a file that is no 3MF; any error of MeshSource::Read and
/// config::JobOfProject.
using ReadProjects = std::function<absl::StatusOr<v1::ReadProjectResponse>(
    const MeshFile& file, const CancelToken& cancel)>;

/// Returns a function that reads projects with `meshes`.
ReadProjects MakeReadProjects(std::shared_ptr<const MeshSource> meshes);

}  // namespace slicefarm::slicing
