#include "services/slicing/algo/placement/prepared_object.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/moved.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/mesh_part.h"
#include "services/slicing/algo/placement/build_volume.h"
#include "services/slicing/algo/placement/footprint.h"
#include "services/slicing/algo/placement/placement.h"

namespace slicefarm::slicing {
namespace {

constexpr Coord kUm = 1'000;

Coord ToWholeUm(Coord nm) { return (nm >= 0 ? nm + kUm / 2 : nm - kUm / 2) / kUm * kUm; }
Point ToWholeUm(Point p) { return {ToWholeUm(p.x), ToWholeUm(p.y)}; }

absl::Status Malformed(std::string_view message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
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
      auto read = source_.Read(std::exchange(files_[file].bytes, {}), files_[file].format,
                               limits::kMaxMeshCoordinateMm, ReadDepth::kMeshes, cancel_);
      if (!read.ok()) return read.status();
      meshes_[file] = std::move(read->meshes);
    }
    if (ref.mesh < 0 || ref.mesh >= std::ssize(*meshes_[file]))
      return Malformed("a part refers to a mesh that is not in its file");
    absl::StatusOr<RawMesh> part = MeshPart((*meshes_[file])[static_cast<size_t>(ref.mesh)], ref);
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

Point ShiftOf(const CopyInput& copy, const Vertex& to_origin, Point bed_center) {
  switch (copy.place) {
    case CopyInput::Place::kMiddleAt:
      return ToWholeUm(copy.at);
    case CopyInput::Place::kOriginAt:
      return ToWholeUm(Point{copy.at.x - to_origin.x, copy.at.y - to_origin.y});
    default:
      return ToWholeUm(bed_center);
  }
}

/// Prepares one object after the other.
class Preparation {
 public:
  Preparation(Meshes& meshes, const SlicingOptions& options, const CancelToken& cancel)
      : meshes_(meshes), options_(options), cancel_(cancel) {}

  absl::StatusOr<PreparedObject> Prepare(const ObjectInput& input,
                                         const ObjectSlicingOptions& slicing) {
    PreparedObject object;
    object.name = input.name;
    object.ranges = input.ranges;
    absl::StatusOr<std::vector<PlacedPart>> parts = PlaceParts(input);
    if (!parts.ok()) return parts.status();
    const Extent placed = SolidExtent(input, *parts);
    const Vertex to_origin = ToOrigin(placed, FromMm(input.sunk_mm));
    for (PlacedPart& part : *parts) MoveBy(part.mesh, to_origin);
    if (absl::Status fits = Fit(input, *parts, to_origin, slicing, object); !fits.ok()) return fits;
    for (size_t i = 0; i < parts->size(); ++i) {
      absl::StatusOr<PreparedPart> part =
          Connected(input.parts[i], std::move((*parts)[i]), object.shifts.front());
      if (!part.ok()) return part.status();
      if (part->report.name.empty()) part->report.name = input.name;
      object.parts.push_back(*std::move(part));
    }
    return object;
  }

 private:
  absl::StatusOr<std::vector<PlacedPart>> PlaceParts(const ObjectInput& input) {
    std::vector<PlacedPart> parts;
    for (const PartInput& part : input.parts) {
      absl::StatusOr<RawMesh> raw = meshes_.Take(part.mesh);
      if (!raw.ok()) return raw.status();
      absl::StatusOr<PlacedPart> placed = Place(*raw, Combined(input.to_plate, part.to_object));
      if (!placed.ok()) return placed.status();
      parts.push_back(*std::move(placed));
    }
    return parts;
  }

  static Extent SolidExtent(const ObjectInput& input, const std::vector<PlacedPart>& parts) {
    Extent extent;
    for (size_t i = 0; i < parts.size(); ++i)
      if (input.parts[i].role == PartRole::kSolid) extent.Add(ExtentOf(parts[i].mesh));
    return extent;
  }

  /// Finds the copies' places and checks that the object fits there.
  absl::Status Fit(const ObjectInput& input, const std::vector<PlacedPart>& parts,
                   const Vertex& to_origin, const ObjectSlicingOptions& slicing,
                   PreparedObject& object) const {
    Extent extent;
    for (const PlacedPart& part : parts) extent.Add(ExtentOf(part.mesh));
    if (absl::Status reach = CheckReach(extent); !reach.ok()) return reach;
    std::vector<const IndexedMesh*> solid;
    for (size_t i = 0; i < parts.size(); ++i)
      if (input.parts[i].role == PartRole::kSolid) solid.push_back(&parts[i].mesh);
    object.top_nm = SolidExtent(input, parts).max.z;
    object.footprint = Footprint(solid);
    const Point bed_center = BedCenter(options_.bed);
    for (const CopyInput& copy : input.copies)
      object.shifts.push_back(ShiftOf(copy, to_origin, bed_center));
    return CheckBuildVolume({object.footprint, object.top_nm, slicing.xy_compensation_nm},
                            input.name, object.shifts, options_);
  }

  absl::StatusOr<PreparedPart> Connected(const PartInput& input, PlacedPart placed, Point shift) {
    absl::StatusOr<ConnectedMesh> connected = Connect(std::move(placed.mesh), cancel_);
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

  Meshes& meshes_;
  const SlicingOptions& options_;
  const CancelToken& cancel_;
};

/// The error with its object in front, where there are several to look at.
absl::Status OfObject(const std::vector<ObjectInput>& objects, size_t index,
                      const absl::Status& status) {
  if (objects.size() == 1 || absl::IsCancelled(status)) return status;
  ErrorDetail detail = DetailOf(status);
  detail.metadata["object"] = absl::StrCat(index);
  // The name is the user's and may hold anything.
  const std::string name = absl::Utf8SafeCEscape(objects[index].name);
  return MakeError(status.code(), detail.reason,
                   absl::StrCat("object ", index, " (\"", name, "\"): ", status.message()),
                   std::move(detail.metadata));
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
  Meshes meshes(std::move(input.files), input.objects, source, cancel);
  Preparation preparation(meshes, options, cancel);
  std::vector<PreparedObject> objects;
  for (size_t i = 0; i < input.objects.size(); ++i) {
    absl::StatusOr<PreparedObject> object =
        preparation.Prepare(input.objects[i], options.objects[i]);
    if (!object.ok()) return OfObject(input.objects, i, object.status());
    objects.push_back(*std::move(object));
  }
  return objects;
}

}  // namespace slicefarm::slicing
