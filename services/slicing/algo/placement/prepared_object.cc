#include "services/slicing/algo/placement/prepared_object.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/mesh_part.h"
#include "services/slicing/algo/mesh_io/mesh_reader.h"
#include "services/slicing/algo/placement/build_volume.h"
#include "services/slicing/algo/placement/copy_places.h"
#include "services/slicing/algo/placement/footprint.h"
#include "services/slicing/algo/placement/placement.h"

namespace slicefarm::slicing {
namespace {

absl::Status Malformed(std::string_view message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

/// A project says how its meshes are turned, scaled and combined: to print them as they lie in the
/// file would be wrong.
absl::Status CheckNoProject(const MeshFile& file) {
  const MeshFormat format =
      file.format == MeshFormat::kUnknown ? DetectFormat(file.bytes) : file.format;
  if (format != MeshFormat::k3mf) return absl::OkStatus();
  return Malformed(
      "a 3MF project is no single mesh: the job must name its objects, their parts and places");
}

/// The meshes of the files, each file's freed after their last use.
class Meshes {
 public:
  Meshes(std::vector<MeshFile> files, const std::vector<ObjectInput>& objects,
         const MeshSource& source, const CancelToken& cancel)
      : files_(std::move(files)), meshes_(files_.size()), uses_(files_.size(), 0),
        source_(source), cancel_(cancel) {
    for (const ObjectInput& object : objects)
      for (const PartInput& part : object.parts)
        if (Has(part.mesh)) ++uses_[static_cast<size_t>(part.mesh.file)];
  }

  absl::StatusOr<RawMesh> Take(const MeshRef& ref) {
    if (!Has(ref)) return Malformed("a part refers to a file that is not there");
    const auto file = static_cast<size_t>(ref.file);
    if (!meshes_[file]) {
      if (ref.mesh == kOnlyMesh)
        if (absl::Status ok = CheckNoProject(files_[file]); !ok.ok()) return ok;
      auto read = source_.Read(std::exchange(files_[file].bytes, {}), files_[file].format,
                               limits::kMaxMeshCoordinateMm, ReadDepth::kMeshes, cancel_);
      if (!read.ok()) return read.status();
      meshes_[file] = std::move(read->meshes);
    }
    const int32_t mesh = ref.mesh == kOnlyMesh ? 0 : ref.mesh;
    if (mesh < 0 || mesh >= std::ssize(*meshes_[file]))
      return Malformed("a part refers to a mesh that is not in its file");
    absl::StatusOr<RawMesh> part = MeshPart((*meshes_[file])[static_cast<size_t>(mesh)], ref);
    if (--uses_[file] == 0) meshes_[file].reset();
    return part;
  }

 private:
  bool Has(const MeshRef& ref) const { return 0 <= ref.file && ref.file < std::ssize(files_); }

  std::vector<MeshFile> files_;
  std::vector<std::optional<std::vector<RawMesh>>> meshes_;
  std::vector<int> uses_;  ///< to come, by file
  const MeshSource& source_;
  const CancelToken& cancel_;
};

/// A part's triangles in nm, and the edges as the file has them where rounding welds corners.
struct PlacedPart {
  IndexedMesh mesh;
  std::optional<EdgeCounts> edges_of_file;
  int64_t vertices_of_file = 0;
};

absl::StatusOr<PlacedPart> Place(const RawMesh& raw, const Transform& transform) {
  absl::StatusOr<IndexedMesh> mesh = TransformMesh(raw, transform);
  if (!mesh.ok()) return mesh.status();
  PlacedPart part{*std::move(mesh), {}, static_cast<int64_t>(raw.positions.size())};
  // Points a fraction of a nanometre apart are two points in the file, which the report is about.
  if (part.mesh.vertices.size() < raw.positions.size())
    part.edges_of_file = CountEdges(raw.triangles, raw.positions.size());
  return part;
}

/// An object in nm around its own origin, before its copies have places.
struct PlacedObject {
  std::vector<PlacedPart> parts;
  Vertex to_origin;    ///< what was added to all vertices
  Coord top_nm = 0;    ///< of the solid ones
  Polygon footprint;
};

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

absl::StatusOr<PlacedObject> PlaceParts(const ObjectInput& input, Meshes& meshes) {
  PlacedObject object;
  for (const PartInput& part : input.parts) {
    absl::StatusOr<RawMesh> raw = meshes.Take(part.mesh);
    if (!raw.ok()) return raw.status();
    absl::StatusOr<PlacedPart> placed = Place(*raw, Combined(input.to_plate, part.to_object));
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

absl::StatusOr<PreparedPart> Connected(const PartInput& input, PlacedPart placed, Point shift,
                                       const CancelToken& cancel) {
  absl::StatusOr<ConnectedMesh> connected = Connect(std::move(placed.mesh), cancel);
  if (!connected.ok()) return connected.status();
  PreparedPart part{*std::move(connected), input, {}};
  part.report = ReportOf(part.connected, shift);
  part.report.name = input.name;
  if (placed.edges_of_file) {
    part.report.vertices = placed.vertices_of_file;
    part.report.open_edges = placed.edges_of_file->open;
    part.report.non_manifold_edges = placed.edges_of_file->non_manifold;
  }
  return part;
}

absl::StatusOr<PreparedObject> Prepared(const ObjectInput& input, PlacedObject placed,
                                        std::vector<Point> shifts, const CancelToken& cancel) {
  PreparedObject object;
  object.name = input.name;
  object.ranges = input.ranges;
  object.top_nm = placed.top_nm;
  object.footprint = std::move(placed.footprint);
  object.shifts = std::move(shifts);
  for (size_t i = 0; i < placed.parts.size(); ++i) {
    absl::StatusOr<PreparedPart> part =
        Connected(input.parts[i], std::move(placed.parts[i]), object.shifts.front(), cancel);
    if (!part.ok()) return part.status();
    if (part->report.name.empty()) part->report.name = input.name;
    object.parts.push_back(*std::move(part));
  }
  return object;
}

/// The error with its object in front, where there are several to look at.
absl::Status OfObject(const std::vector<ObjectInput>& objects, size_t index,
                      const absl::Status& status) {
  if (status.ok() || objects.size() == 1 || absl::IsCancelled(status)) return status;
  ErrorDetail detail = DetailOf(status);
  detail.metadata["object"] = absl::StrCat(index);
  // The name is the user's and may hold anything.
  const std::string name = absl::Utf8SafeCEscape(objects[index].name);
  return MakeError(status.code(), detail.reason,
                   absl::StrCat("object ", index, " (\"", name, "\"): ", status.message()),
                   std::move(detail.metadata));
}

bool IsFree(const ObjectInput& object) {
  return std::ranges::any_of(object.copies, [](const CopyInput& copy) {
    return copy.place == CopyInput::Place::kAnywhere;
  });
}

/// Finds the copies' places, and checks that each object fits there.
absl::StatusOr<std::vector<std::vector<Point>>> ShiftsOf(const std::vector<ObjectInput>& inputs,
                                                         const std::vector<PlacedObject>& placed,
                                                         const SlicingOptions& options,
                                                         const CancelToken& cancel) {
  const auto check = [&](size_t i, const std::vector<Point>& at) {
    return OfObject(inputs, i,
                    CheckBuildVolume({placed[i].footprint, placed[i].top_nm,
                                      options.objects[i].xy_compensation_nm},
                                     inputs[i].name, at, options));
  };
  std::vector<ObjectToPlace> objects;
  for (size_t i = 0; i < inputs.size(); ++i) {
    // What does not fit by itself is told with its size.
    if (absl::Status ok = check(i, {BedCenter(options.bed)}); !ok.ok() && IsFree(inputs[i]))
      return ok;
    const Vertex& moved = placed[i].to_origin;
    objects.push_back({inputs[i].name, placed[i].footprint, {-moved.x, -moved.y}, inputs[i].copies});
  }
  auto places = PlaceCopies(objects, options, cancel);
  if (!places.ok()) return places.status();
  for (size_t i = 0; i < inputs.size(); ++i)
    if (absl::Status ok = check(i, (*places)[i]); !ok.ok()) return ok;
  return places;
}

absl::Status CheckObject(const ObjectInput& object) {
  const bool solid = std::ranges::any_of(
      object.parts, [](const PartInput& part) { return part.role == PartRole::kSolid; });
  if (!solid) return Malformed("an object has no solid part");
  if (object.copies.empty()) return Malformed("an object has no copy");
  for (const PartInput& part : object.parts) {
    if (part.regions.size() != object.ranges.size() + 1)
      return Malformed("a part does not name a row of settings for each range of heights");
  }
  return absl::OkStatus();
}

absl::Status CheckInput(const SliceInput& input, const SlicingOptions& options) {
  if (input.files.empty() || input.objects.empty())
    return Malformed("a job needs at least one mesh and one object");
  if (options.objects.size() != input.objects.size())
    return Malformed("a job needs slicing options for each of its objects");
  int64_t copies = 0;
  for (size_t i = 0; i < input.objects.size(); ++i) {
    if (absl::Status ok = CheckObject(input.objects[i]); !ok.ok())
      return OfObject(input.objects, i, ok);
    copies += std::ssize(input.objects[i].copies);
  }
  if (copies <= limits::kMaxObjects) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "objects, copies included", limits::kMaxObjects,
                    copies);
}

}  // namespace

absl::StatusOr<std::vector<PreparedObject>> PrepareObjects(SliceInput input,
                                                           const MeshSource& source,
                                                           const SlicingOptions& options,
                                                           const CancelToken& cancel) {
  if (absl::Status ok = CheckInput(input, options); !ok.ok()) return ok;
  const std::vector<ObjectInput>& inputs = input.objects;
  Meshes meshes(std::move(input.files), inputs, source, cancel);
  std::vector<PlacedObject> placed;
  for (const ObjectInput& object : inputs) {
    absl::StatusOr<PlacedObject> one = PlaceParts(object, meshes);
    if (!one.ok()) return OfObject(inputs, placed.size(), one.status());
    placed.push_back(*std::move(one));
  }
  absl::StatusOr<std::vector<std::vector<Point>>> shifts =
      ShiftsOf(inputs, placed, options, cancel);
  if (!shifts.ok()) return shifts.status();
  std::vector<PreparedObject> objects;
  for (size_t i = 0; i < inputs.size(); ++i) {
    absl::StatusOr<PreparedObject> object =
        Prepared(inputs[i], std::move(placed[i]), std::move((*shifts)[i]), cancel);
    if (!object.ok()) return OfObject(inputs, i, object.status());
    objects.push_back(*std::move(object));
  }
  return objects;
}

}  // namespace slicefarm::slicing
