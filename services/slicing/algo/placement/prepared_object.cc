#include "services/slicing/algo/placement/prepared_object.h"

#include <algorithm>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/moved.h"
#include "common/model/limits.h"
#include "services/slicing/algo/placement/build_volume.h"
#include "services/slicing/algo/placement/copy_positions.h"
#include "services/slicing/algo/placement/placed_object.h"

namespace slicefarm::slicing {
namespace {

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
  object.to_origin = placed.to_origin;
  object.top_nm = placed.top_nm;
  object.footprint = std::move(placed.footprint);
  object.to_plate = input.to_plate;
  object.shifts = std::move(shifts);
  const Point first = object.shifts.empty() ? Point{} : object.shifts.front();
  for (size_t i = 0; i < placed.parts.size(); ++i) {
    absl::StatusOr<PreparedPart> part =
        Connected(input.parts[i], std::move(placed.parts[i]), first, cancel);
    if (!part.ok()) return part.status();
    if (part->report.name.empty()) part->report.name = input.name;
    object.parts.push_back(*std::move(part));
  }
  return object;
}

/// Returns the error with the object's number and name in front of its message, if there are
/// several objects.
absl::Status OfObject(const std::vector<ObjectInput>& objects, size_t index,
                      const absl::Status& status) {
  if (status.ok() || objects.size() == 1 || absl::IsCancelled(status)) return status;
  ErrorDetail detail = DetailOf(status);
  detail.metadata["object"] = absl::StrCat(index);
  // The name comes from the user and may contain anything.
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

/// Positions of the copies, indexed by object and copy.
using Shifts = std::vector<std::vector<Point>>;

bool IsOffBed(const Polygon& footprint, Point shift, const Polygon& bed) {
  return bed.size() >= 3 && footprint.size() >= 3 &&
         Intersection({{Moved(footprint, shift), {}}}, {{bed, {}}}).empty();
}

/// Removes the copies beside the bed from `shifts`, because they are not printed. Returns the
/// number of removed copies of each object. If all copies are beside the bed, none is removed.
std::vector<int64_t> TakeParked(const std::vector<ObjectInput>& inputs,
                                const std::vector<PlacedObject>& placed, const Polygon& bed,
                                Shifts& shifts) {
  Shifts on_bed(shifts.size());
  std::vector<int64_t> parked(shifts.size(), 0);
  for (size_t i = 0; i < shifts.size(); ++i) {
    for (size_t copy = 0; copy < shifts[i].size(); ++copy) {
      const bool has_place = inputs[i].copies[copy].place != CopyInput::Place::kAnywhere;
      const Point shift = shifts[i][copy];
      if (has_place && IsOffBed(placed[i].footprint, shift, bed)) {
        ++parked[i];
      } else {
        on_bed[i].push_back(shift);
      }
    }
  }
  if (std::ranges::all_of(on_bed, [](const auto& own) { return own.empty(); }))
    return std::vector<int64_t>(shifts.size(), 0);
  shifts = std::move(on_bed);
  return parked;
}

/// Finds the positions of the copies and removes the copies beside the bed; `parked` receives the
/// number of removed copies of each object. Checks that each remaining copy fits at its position.
absl::StatusOr<Shifts> ShiftsOf(const std::vector<ObjectInput>& inputs,
                                const std::vector<PlacedObject>& placed,
                                const SlicingOptions& options, const CancelToken& cancel,
                                std::vector<int64_t>& parked) {
  const auto check = [&](size_t i, const std::vector<Point>& at, const SlicingOptions& bed) {
    return OfObject(
        inputs, i,
        CheckBuildVolume({placed[i].footprint, placed[i].top_nm + options.objects[i].lift_nm,
                          options.objects[i].xy_compensation_nm},
                         inputs[i].name, at, bed));
  };
  SlicingOptions whole_bed = options;
  whole_bed.excluded.clear();
  whole_bed.wrapping.clear();
  std::vector<ObjectToPlace> objects;
  for (size_t i = 0; i < inputs.size(); ++i) {
    // An object that is too large even alone gets an error with its size.
    if (absl::Status ok = check(i, {BedCenter(options.bed)}, whole_bed);
        !ok.ok() && IsFree(inputs[i]))
      return ok;
    const Vertex& moved = placed[i].to_origin;
    objects.push_back(
        {inputs[i].name, placed[i].footprint, {-moved.x, -moved.y}, inputs[i].copies});
  }
  auto places = PlaceCopies(objects, options, cancel);
  if (!places.ok()) return places.status();
  parked = TakeParked(inputs, placed, options.bed, *places);
  for (size_t i = 0; i < inputs.size(); ++i)
    if (absl::Status ok = check(i, (*places)[i], options); !ok.ok()) return ok;
  return places;
}

absl::Status CheckObject(const ObjectInput& object) {
  const bool solid = std::ranges::any_of(
      object.parts, [](const PartInput& part) { return part.role == PartRole::kSolid; });
  if (!solid) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "no part of the object is solid: modifiers are not printed");
  }
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
  PartMeshes meshes(std::move(input.files), inputs, source, cancel);
  std::vector<PlacedObject> placed;
  for (const ObjectInput& object : inputs) {
    absl::StatusOr<PlacedObject> one = PlaceParts(object, meshes);
    if (!one.ok()) return OfObject(inputs, placed.size(), one.status());
    placed.push_back(*std::move(one));
  }
  std::vector<int64_t> parked;
  absl::StatusOr<Shifts> shifts = ShiftsOf(inputs, placed, options, cancel, parked);
  if (!shifts.ok()) return shifts.status();
  std::vector<PreparedObject> objects;
  for (size_t i = 0; i < inputs.size(); ++i) {
    absl::StatusOr<PreparedObject> object =
        Prepared(inputs[i], std::move(placed[i]), std::move((*shifts)[i]), cancel);
    if (!object.ok()) return OfObject(inputs, i, object.status());
    object->copies_off_bed = parked[i];
    objects.push_back(*std::move(object));
  }
  return objects;
}

}  // namespace slicefarm::slicing
