#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/mesh.h"
#include "common/model/slicing_options.h"
#include "services/slicing/algo/mesh_io/mesh_source.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing {

/// A mesh ready to be cut, with the middle of its box over the origin, and where its copies go.
struct PreparedMesh {
  ConnectedMesh connected;
  std::vector<Point> centers;
  MeshReport report;
};

/// Reads by `source`, places, checks and connects one file, whose bytes are freed on the way.
/// Errors: those of the steps.
absl::StatusOr<PreparedMesh> PrepareMesh(MeshFile file, const MeshSource& source,
                                         const Placement& placement, const SlicingOptions& options,
                                         const CancelToken& cancel);

}  // namespace slicefarm::slicing
