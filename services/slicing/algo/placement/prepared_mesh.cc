#include "services/slicing/algo/placement/prepared_mesh.h"

#include <utility>

#include "common/base/error.h"
#include "services/slicing/algo/placement/build_volume.h"
#include "services/slicing/algo/placement/placement.h"

namespace slicefarm::slicing {

namespace {

/// What a file with several meshes has besides is not placed yet. Takes the file's bytes.
absl::StatusOr<RawMesh> ReadFirstMesh(MeshFile& file, const MeshSource& source,
                                      double coordinate_limit, const CancelToken& cancel) {
  absl::StatusOr<MeshFileContents> contents =
      source.Read(std::move(file.bytes), file.format, coordinate_limit, ReadDepth::kMeshes, cancel);
  if (!contents.ok()) return contents.status();
  RawMesh& first = contents->meshes.front();
  if (first.triangles.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the file's first mesh has no triangles");
  return std::move(first);
}

/// The report is about the file, where points a fraction of a nanometre apart are two points;
/// rounding welds them for the slicing.
void ReportEdgesOfFile(const RawMesh& raw, MeshReport& report) {
  const EdgeCounts counts = CountEdges(raw.triangles, raw.positions.size());
  report.vertices = static_cast<int64_t>(raw.positions.size());
  report.open_edges = counts.open;
  report.non_manifold_edges = counts.non_manifold;
}

}  // namespace

absl::StatusOr<PreparedMesh> PrepareMesh(MeshFile file, const MeshSource& source,
                                         const Placement& placement, const SlicingOptions& options,
                                         const CancelToken& cancel) {
  if (absl::Status status = CheckPlacement(placement); !status.ok()) return status;
  absl::StatusOr<RawMesh> raw = ReadFirstMesh(file, source, CoordinateLimit(placement), cancel);
  if (!raw.ok()) return raw.status();
  absl::StatusOr<IndexedMesh> placed = PlaceMesh(*raw, placement);
  if (!placed.ok()) return placed.status();
  PreparedMesh prepared;
  prepared.centers = placement.centers;
  if (prepared.centers.empty()) prepared.centers = {BedCenter(options.bed)};
  absl::Status fits = CheckBuildVolume(*placed, file.name, prepared.centers, options);
  if (!fits.ok()) return fits;
  const bool rounding_welds = placed->vertices.size() < raw->positions.size();
  if (!rounding_welds) *raw = {};
  absl::StatusOr<ConnectedMesh> connected = Connect(*std::move(placed), cancel);
  if (!connected.ok()) return connected.status();
  prepared.connected = *std::move(connected);
  prepared.report = ReportOf(prepared.connected, prepared.centers.front());
  prepared.report.name = std::move(file.name);
  if (rounding_welds) ReportEdgesOfFile(*raw, prepared.report);
  return prepared;
}

}  // namespace slicefarm::slicing
