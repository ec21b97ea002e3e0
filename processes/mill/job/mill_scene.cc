#include "processes/mill/job/mill_scene.h"

#include <algorithm>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::coordinator {
namespace {

absl::Status StockError(std::string_view stock, std::string_view what,
                        const std::vector<ObjectInput>& objects) {
  std::string names;
  for (const ObjectInput& object : objects)
    absl::StrAppend(&names, names.empty() ? "" : ", ", absl::Utf8SafeCEscape(object.name));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   absl::StrCat("stock = '", absl::Utf8SafeCEscape(std::string(stock)), "' ",
                                std::string(what), "; the objects are: ", names),
                   {{"setting", "stock"}, {"value", std::string(stock)}});
}

/// Returns the files of the job, with the same numbers. Files that the object does not use have
/// only a name and no bytes.
std::vector<MeshFile> FilesOf(const ObjectInput& object, const std::vector<MeshFile>& files) {
  std::vector<MeshFile> own;
  for (size_t i = 0; i < files.size(); ++i) {
    const bool used = std::ranges::any_of(object.parts, [&](const PartInput& part) {
      return part.mesh.file == static_cast<int32_t>(i);
    });
    own.push_back({files[i].name, files[i].format, used ? files[i].bytes : ""});
  }
  return own;
}

/// A box in nm.
struct Bounds {
  Vertex min{INT64_MAX, INT64_MAX, INT64_MAX};
  Vertex max{INT64_MIN, INT64_MIN, INT64_MIN};

  void Add(const Vertex& v) {
    min = {std::min(min.x, v.x), std::min(min.y, v.y), std::min(min.z, v.z)};
    max = {std::max(max.x, v.x), std::max(max.y, v.y), std::max(max.z, v.z)};
  }
};

Vertex Sum(const Vertex& a, const Vertex& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vertex Minus(const Vertex& a) { return {-a.x, -a.y, -a.z}; }
Vertex At(Point shift) { return {shift.x, shift.y, 0}; }

/// Calls `visit` with each solid part and the shift of each of its copies.
template <class Visit>
void ForEachCopy(const PlacedScene& scene, const Visit& visit) {
  for (const PlacedSceneObject& object : scene.objects)
    for (const Point shift : object.shifts)
      for (const PlacedScenePart& part : object.parts)
        if (part.role == PartRole::kSolid) visit(part.mesh, shift);
}

Bounds BoundsOf(const PlacedScene& scene) {
  Bounds bounds;
  ForEachCopy(scene, [&](const IndexedMesh& mesh, Point shift) {
    for (const Vertex& v : mesh.vertices) bounds.Add(Sum(v, At(shift)));
  });
  return bounds;
}

/// Returns all copies on the bed as one mesh, moved by `by`.
IndexedMesh Joined(const PlacedScene& scene, const Vertex& by) {
  IndexedMesh all;
  ForEachCopy(scene, [&](const IndexedMesh& mesh, Point shift) {
    const auto first = static_cast<uint32_t>(all.vertices.size());
    for (const Vertex& v : mesh.vertices) all.vertices.push_back(Sum(Sum(v, At(shift)), by));
    for (const auto& t : mesh.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  });
  return all;
}

absl::Status CheckRoles(const PlacedScene& scene) {
  for (const PlacedSceneObject& object : scene.objects)
    for (const PlacedScenePart& part : object.parts)
      if (part.role == PartRole::kNegative)
        return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                         absl::StrCat("object \"", absl::Utf8SafeCEscape(object.name),
                                      "\" has a negative part: milling does not subtract meshes "
                                      "from each other; remove the part"));
  return absl::OkStatus();
}

absl::Status CheckSize(const IndexedMesh& mesh) {
  if (std::ssize(mesh.triangles) <= limits::kMaxTriangles) return absl::OkStatus();
  return LimitError(Reason::kMeshTooLarge, "triangles of all copies", limits::kMaxTriangles,
                    std::ssize(mesh.triangles));
}

absl::Status CheckReach(const IndexedMesh& mesh) {
  for (const Vertex& v : mesh.vertices)
    for (const Coord c : {v.x, v.y, v.z})
      if (std::abs(c) > limits::kMaxCoord)
        return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                         absl::StrCat("a part reaches ", ToMm(static_cast<double>(std::abs(c))),
                                      " mm from the program's origin, but at most ",
                                      ToMm(static_cast<double>(limits::kMaxCoord)),
                                      " mm are possible; use origin = bed or stock_top"));
  return absl::OkStatus();
}

/// Returns the vector from bed coordinates to program coordinates.
Vertex ToProgram(const PlacedScene& parts, const std::optional<PlacedScene>& stock,
                 const MillSettings& settings) {
  switch (settings.origin) {
    case MillOrigin::kBed:
      return {};
    case MillOrigin::kModel:
      for (const PlacedSceneObject& object : parts.objects)
        if (!object.shifts.empty()) return Minus(Sum(At(object.shifts.front()), object.to_origin));
      return {};
    case MillOrigin::kStockTop: {
      const Bounds bounds = BoundsOf(stock ? *stock : parts);
      const Coord margin = stock ? 0 : FromMm(settings.how.stock_margin_mm);
      return {margin - bounds.min.x, margin - bounds.min.y, -bounds.max.z - margin};
    }
  }
  return {};
}

void AddReports(PlacedScene& scene, const Vertex& by, MillScene& result) {
  for (PlacedSceneObject& object : scene.objects) {
    for (PlacedScenePart& part : object.parts) {
      if (part.role != PartRole::kSolid) {
        result.warnings.push_back(
            absl::StrCat(object.name, ": ", part.report.name,
                         " is not a solid part and has no effect on milling"));
        continue;
      }
      const Coord moved[] = {by.x, by.y, by.z};
      for (size_t axis = 0; axis < 3; ++axis) {
        part.report.min_mm[axis] += ToMm(static_cast<double>(moved[axis]));
        part.report.max_mm[axis] += ToMm(static_cast<double>(moved[axis]));
      }
      result.meshes.push_back(std::move(part.report));
    }
  }
}

}  // namespace

absl::StatusOr<PartsAndStock> TakeStock(PlacingInput job, std::string_view stock) {
  if (stock.empty()) return PartsAndStock{std::move(job), std::nullopt};
  std::vector<ObjectInput>& objects = job.meshes.objects;
  const auto named = [&](const ObjectInput& object) { return object.name == stock; };
  const auto found = std::ranges::find_if(objects, named);
  if (found == objects.end()) return StockError(stock, "is not the name of an object", objects);
  if (std::ranges::count_if(objects, named) > 1 || found->copies.size() > 1)
    return StockError(stock, "is the name of several objects or copies", objects);
  if (objects.size() == 1)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "the stock is the only object: add the part to mill out of it");
  const auto index = found - objects.begin();
  PlacingInput own;
  own.meshes.files = FilesOf(*found, job.meshes.files);
  own.meshes.objects = {std::move(*found)};
  own.options = job.options;
  own.options.objects = {job.options.objects[static_cast<size_t>(index)]};
  // A stock may be larger than the table.
  own.options.bed.clear();
  own.options.max_print_height_nm = 0;
  objects.erase(found);
  job.options.objects.erase(job.options.objects.begin() + index);
  return PartsAndStock{std::move(job), std::move(own)};
}

void PutAround(const PlacedScene& parts, PlacingInput& stock) {
  CopyInput& copy = stock.meshes.objects.front().copies.front();
  if (copy.place != CopyInput::Place::kAnywhere) return;
  const Bounds bounds = BoundsOf(parts);
  copy.place = CopyInput::Place::kMiddleAt;
  copy.at = {(bounds.min.x + bounds.max.x) / 2, (bounds.min.y + bounds.max.y) / 2};
}

absl::StatusOr<MillScene> MillSceneOf(PlacedScene parts, std::optional<PlacedScene> stock,
                                      const MillSettings& settings) {
  if (absl::Status roles = CheckRoles(parts); !roles.ok()) return roles;
  const Vertex by = ToProgram(parts, stock, settings);
  MillScene result;
  result.input.part = Joined(parts, by);
  if (stock) result.input.stock = Joined(*stock, by);
  for (const IndexedMesh* mesh : {&result.input.part, &result.input.stock}) {
    absl::Status sound = CheckSize(*mesh);
    sound.Update(CheckReach(*mesh));
    if (!sound.ok()) return sound;
  }
  AddReports(parts, by, result);
  if (stock) AddReports(*stock, by, result);
  result.input.settings = settings;
  return result;
}

}  // namespace slicefarm::coordinator
