#include "services/slicing/algo/mesh_io/threemf/parts.h"

#include <fmt/core.h>

#include <algorithm>

#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {
namespace {

void NotePaint(const ObjectResource& object, std::string_view name, Notes& notes) {
  if (object.paint & kPaintedFuzzySkin) notes.Add("painted fuzzy skin", name);
  if (object.coloured) notes.Add("materials and colours", name);
}

/// Checks that the triangle ranges do not overlap and do not end beyond the last triangle.
absl::Status CheckRanges(const std::vector<PartSettings>& parts, int64_t triangles,
                         const std::string& file) {
  std::vector<const PartSettings*> sorted;
  for (const PartSettings& part : parts) sorted.push_back(&part);
  std::sort(sorted.begin(), sorted.end(), [](const PartSettings* a, const PartSettings* b) {
    return a->first_triangle < b->first_triangle;
  });
  int64_t next = 0;
  for (const PartSettings* part : sorted) {
    const int64_t first = part->first_triangle, last = part->last_triangle;
    if (first < next || last < first || last >= triangles)
      return WithLocation(
          {file, part->line},
          Malformed(fmt::format("a volume of triangles {} to {} of {}, where {} is the "
                                "first that no other volume has",
                                first, last, triangles, next)));
    next = last + 1;
  }
  return absl::OkStatus();
}

/// Returns PrusaSlicer's volumes of an object with a mesh, as parts.
absl::StatusOr<std::vector<Part>> Volumes(const PartsSource& source, const ObjectResource& object,
                                          const ObjectSettings& settings) {
  absl::Status status = CheckRanges(settings.parts, object.triangles, source.settings.part);
  if (!status.ok()) return status;
  std::vector<Part> parts;
  for (const PartSettings& volume : settings.parts) {
    Part part;
    part.name = volume.name;
    part.role = volume.role;
    part.settings = volume.settings;
    part.mesh.mesh = object.mesh;
    part.mesh.first_triangle = volume.first_triangle;
    part.mesh.triangle_count = volume.last_triangle - volume.first_triangle + 1;
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Returns the settings of the object's mesh `index`, which belongs to `component`; null if there
/// are none. A mesh that is used twice has two entries with the same id. So the entry with the
/// index `index` is tried first, as Bambu Studio does.
const PartSettings* SettingsOf(const ObjectSettings* object, size_t index, ResourceId component) {
  if (object == nullptr) return nullptr;
  const std::vector<PartSettings>& parts = object->parts;
  if (index < parts.size() && parts[index].component == component) return &parts[index];
  const auto found = std::ranges::find(parts, component, &PartSettings::component);
  return found == parts.end() ? nullptr : &*found;
}

Part PartOf(const FlatPart& flat, const ObjectResource& mesh, const PartSettings* settings) {
  Part part;
  part.name = mesh.name;
  part.mesh.mesh = mesh.mesh;
  part.to_object = flat.to_object;
  if (settings == nullptr) return part;
  if (!settings->name.empty()) part.name = settings->name;
  part.role = settings->role;
  part.settings = settings->settings;
  return part;
}

/// Adds the painted areas of a mesh of the object as parts.
void AddMarks(const MeshPaint& marks, const Transform& to_object, std::vector<Part>& parts) {
  const auto add = [&](const PaintedArea& area, std::string_view name, PartRole role) {
    if (area.triangles == 0) return;
    Part& part = parts.emplace_back();
    part.name = name;
    part.role = role;
    part.mesh.mesh = area.number;
    part.mesh.triangle_count = area.triangles;
    part.to_object = to_object;
  };
  add(marks.seams.enforcers, "painted seams", PartRole::kSeamEnforcer);
  add(marks.seams.blockers, "painted seams", PartRole::kSeamBlocker);
  add(marks.supports.enforcers, "painted supports", PartRole::kSupportEnforcer);
  add(marks.supports.blockers, "painted supports", PartRole::kSupportBlocker);
}

bool HasVolumes(const ObjectResource& object, const ObjectSettings* settings) {
  return settings != nullptr && object.mesh >= 0 && !settings->parts.empty() &&
         settings->parts.front().component == 0;
}

}  // namespace

absl::StatusOr<std::vector<Part>> PartsOf(const PartsSource& source, const ObjectKey& key,
                                          std::string_view name, Notes& notes) {
  const ObjectResource& object = source.package.At(key);
  const ObjectSettings* settings =
      source.package.IsNamedByNumber(key) ? source.settings.Of(object.id) : nullptr;
  if (HasVolumes(object, settings)) {
    NotePaint(object, name, notes);
    absl::StatusOr<std::vector<Part>> volumes = Volumes(source, object, *settings);
    if (!volumes.ok()) return volumes;
    int64_t used = 0;
    for (const Part& part : *volumes) used += part.mesh.triangle_count;
    if (used < object.triangles) notes.Add("triangles of no part", name);
    AddMarks(object.marks, Transform(Transform::Identity()), *volumes);
    return volumes;
  }
  const absl::StatusOr<std::vector<FlatPart>> flat = source.tree.Flatten(key);
  if (!flat.ok()) return flat.status();
  std::vector<Part> parts;
  for (size_t i = 0; i < flat->size(); ++i) {
    const FlatPart& each = (*flat)[i];
    const ObjectResource& mesh = source.package.At(each.mesh_object);
    NotePaint(mesh, name, notes);
    if (mesh.triangles == 0) {
      notes.Add("parts without a triangle", name);
      continue;
    }
    parts.push_back(PartOf(each, mesh, SettingsOf(settings, i, each.component)));
    AddMarks(mesh.marks, each.to_object, parts);
  }
  return parts;
}

absl::StatusOr<bool> HasPaintedFilaments(const PartsSource& source, const ObjectKey& key) {
  const auto flat = source.tree.Flatten(key);
  if (!flat.ok()) return flat.status();
  return std::ranges::any_of(*flat, [&](const FlatPart& each) {
    return (source.package.At(each.mesh_object).paint & kPaintedColours) != 0;
  });
}

}  // namespace slicefarm::slicing::threemf
