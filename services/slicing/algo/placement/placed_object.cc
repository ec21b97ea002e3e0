#include "services/slicing/algo/placement/placed_object.h"

#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/mesh_part.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/placement/arranging/footprint.h"
#include "services/slicing/algo/placement/placement.h"

namespace slicefarm::slicing {
namespace {

/// Returns an error if a 3MF project is used as a single mesh. A project defines how its meshes are
/// rotated, scaled and combined, so printing them as they are in the file would be wrong.
absl::Status CheckNoProject(const MeshFile& file) {
  const MeshFormat format =
      file.format == MeshFormat::kUnknown ? DetectFormat(file.bytes) : file.format;
  if (format != MeshFormat::k3mf) return absl::OkStatus();
  return Malformed(
      "a 3MF project is not a single mesh: the job must name its objects, their parts and "
      "positions");
}

absl::StatusOr<PlacedPart> PlacedPartOf(const RawMesh& raw, const Transform& transform) {
  absl::StatusOr<IndexedMesh> mesh = TransformMesh(raw, transform);
  if (!mesh.ok()) return mesh.status();
  PlacedPart part{*std::move(mesh), {}, static_cast<int64_t>(raw.positions.size())};
  // Rounding has merged points that are distinct in the file. The report is about the file, so it
  // counts the file's edges.
  if (part.mesh.vertices.size() < raw.positions.size())
    part.edges_of_file = CountEdges(raw.triangles, raw.positions.size());
  return part;
}

Extent SolidExtent(const ObjectInput& input, const std::vector<PlacedPart>& parts) {
  Extent extent;
  for (size_t i = 0; i < parts.size(); ++i)
    if (input.parts[i].role == PartRole::kSolid) extent.Add(ExtentOf(parts[i].mesh));
  return extent;
}

Polygon SolidFootprint(const ObjectInput& input, const std::vector<PlacedPart>& parts) {
  std::vector<const IndexedMesh*> solid;
  for (size_t i = 0; i < parts.size(); ++i)
    if (input.parts[i].role == PartRole::kSolid) solid.push_back(&parts[i].mesh);
  return Footprint(solid);
}

}  // namespace

absl::Status Malformed(std::string_view message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

PartMeshes::PartMeshes(std::vector<MeshFile> files, const std::vector<ObjectInput>& objects,
                       const MeshSource& source, const CancelToken& cancel, ReadDepth depth)
    : files_(std::move(files)),
      meshes_(files_.size()),
      uses_(files_.size(), 0),
      source_(source),
      cancel_(cancel),
      depth_(depth) {
  for (const ObjectInput& object : objects)
    for (const PartInput& part : object.parts)
      if (Has(part.mesh)) ++uses_[static_cast<size_t>(part.mesh.file)];
}

absl::StatusOr<RawMesh> PartMeshes::Take(const MeshRef& ref) {
  if (!Has(ref)) return Malformed("a part refers to a file that is missing");
  const auto file = static_cast<size_t>(ref.file);
  if (!meshes_[file]) {
    if (ref.mesh == kOnlyMesh)
      if (absl::Status ok = CheckNoProject(files_[file]); !ok.ok()) return ok;
    auto read = source_.Read(std::exchange(files_[file].bytes, {}), files_[file].format,
                             limits::kMaxMeshCoordinateMm, depth_, cancel_);
    if (!read.ok()) return read.status();
    meshes_[file] = std::move(read->meshes);
  }
  const int32_t mesh = ref.mesh == kOnlyMesh ? 0 : ref.mesh;
  if (mesh < 0 || mesh >= std::ssize(*meshes_[file]))
    return Malformed("a part refers to a mesh that is not in its file");
  absl::StatusOr<RawMesh> part = MeshPart((*meshes_[file])[static_cast<size_t>(mesh)], ref);
  if (--uses_[file] == 0) meshes_[file].reset();
  if (!part.ok()) return part;
  taken_ += std::ssize(part->triangles);
  if (taken_ > limits::kMaxTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles of all parts", limits::kMaxTriangles,
                      taken_);
  return part;
}

absl::StatusOr<PlacedObject> PlaceParts(const ObjectInput& input, PartMeshes& meshes) {
  PlacedObject object;
  for (const PartInput& part : input.parts) {
    absl::StatusOr<RawMesh> raw = meshes.Take(part.mesh);
    if (!raw.ok()) return raw.status();
    absl::StatusOr<PlacedPart> placed =
        PlacedPartOf(*raw, Combined(input.to_plate, part.to_object));
    if (!placed.ok()) return placed.status();
    object.parts.push_back(*std::move(placed));
  }
  const Extent solid = SolidExtent(input, object.parts);
  object.to_origin = ToOrigin(solid, FromMm(input.sunk_mm));
  Extent extent;
  for (PlacedPart& part : object.parts) {
    MoveBy(part.mesh, object.to_origin);
    extent.Add(ExtentOf(part.mesh));
  }
  if (absl::Status reach = CheckReach(extent); !reach.ok()) return reach;
  object.top_nm = solid.max.z + object.to_origin.z;
  object.footprint = SolidFootprint(input, object.parts);
  return object;
}

}  // namespace slicefarm::slicing
