#include "services/slicing/sandbox/project_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/base/text.h"
#include "common/base/utf8.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

using Triangles = std::optional<std::span<const int64_t>>;

template <typename T>
bool AtMost(const std::vector<T>& items, int64_t most) {
  return static_cast<int64_t>(items.size()) <= most;
}

bool IsText(std::string_view text, int64_t most_bytes) {
  return static_cast<int64_t>(text.size()) <= most_bytes && IsUtf8(text);
}

bool IsName(std::string_view text) {
  return IsText(text, limits::kMaxNameBytes) && std::none_of(text.begin(), text.end(), IsControl);
}

bool AreSettings(const std::vector<Setting>& settings) {
  return AtMost(settings, limits::kMaxSettings) &&
         std::all_of(settings.begin(), settings.end(), [](const Setting& setting) {
           return !setting.key.empty() && IsName(setting.key) &&
                  setting.source <= Source::kRequest &&
                  IsText(setting.value, limits::kMaxSettingBytes);
         });
}

/// Returns true if all entries of a transform are within their limits. The limits are larger than
/// for a transform in a file, because the offset of a plate and combined components are included.
bool IsTransform(const Transform& transform) {
  constexpr double kMost = 2 * limits::kMaxTransformEntry +
                           limits::kMaxMeshCoordinateMm * 1.2 * limits::kMaxProjectPlates;
  return std::all_of(transform.reshaped().begin(), transform.reshaped().end(),
                     [](double entry) { return std::abs(entry) <= kMost; });
}

bool IsMeshRef(const MeshRef& ref, const Triangles& triangles) {
  if (ref.file != 0 || ref.mesh < 0 || ref.first_triangle < 0 || ref.triangle_count < -1)
    return false;
  if (ref.mesh >= limits::kMaxFileResources || ref.triangle_count == 0) return false;
  if (ref.first_triangle > limits::kMaxTriangles || ref.triangle_count > limits::kMaxTriangles)
    return false;
  if (!triangles) return true;
  if (ref.mesh >= static_cast<int64_t>(triangles->size())) return false;
  const int64_t count = (*triangles)[static_cast<size_t>(ref.mesh)];
  return ref.first_triangle + std::max(ref.triangle_count, int64_t{1}) <= count;
}

bool IsPart(const Part& part, const Triangles& triangles) {
  return IsName(part.name) && IsMeshRef(part.mesh, triangles) &&
         part.role <= PartRole::kSeamBlocker && IsTransform(part.to_object) &&
         AreSettings(part.settings);
}

bool IsRange(const HeightRange& range) {
  return std::isfinite(range.from_mm) && std::isfinite(range.to_mm) &&
         range.from_mm < range.to_mm && AreSettings(range.settings);
}

std::string_view FaultOf(const SceneObject& object, const Triangles& triangles) {
  if (!IsName(object.name) || !AreSettings(object.settings)) return "an object of no good text";
  const auto is_part = [&](const Part& part) { return IsPart(part, triangles); };
  if (object.parts.empty() || !std::all_of(object.parts.begin(), object.parts.end(), is_part))
    return "a part that cannot be";
  if (!AtMost(object.ranges, limits::kMaxHeightRanges) ||
      !std::all_of(object.ranges.begin(), object.ranges.end(), IsRange))
    return "height ranges that cannot be";
  const bool good_instances =
      std::all_of(object.instances.begin(), object.instances.end(),
                  [](const Instance& instance) { return IsTransform(instance.to_plate); });
  return good_instances ? "" : "a transform that cannot be";
}

bool IsMember(const ProjectPlate::Member& member, const Project& project) {
  if (member.object < 0 || member.object >= static_cast<int64_t>(project.objects.size()))
    return false;
  const auto copies = static_cast<int64_t>(project.objects[member.object].instances.size());
  return member.instance >= 0 && member.instance < copies;
}

bool IsPlate(const ProjectPlate& plate, const Project& project) {
  return IsName(plate.name) && AreSettings(plate.settings) &&
         AtMost(plate.members, limits::kMaxObjects) &&
         std::all_of(plate.members.begin(), plate.members.end(),
                     [&project](const auto& member) { return IsMember(member, project); });
}

bool HasGoodCounts(const Project& project) {
  int64_t parts = 0, instances = 0;
  for (const SceneObject& object : project.objects) {
    parts += static_cast<int64_t>(object.parts.size());
    instances += static_cast<int64_t>(object.instances.size());
  }
  return !project.objects.empty() && AtMost(project.objects, limits::kMaxObjects) &&
         parts <= limits::kMaxParts && instances <= limits::kMaxObjects &&
         AtMost(project.plates, limits::kMaxProjectPlates) &&
         AtMost(project.without_effect, limits::kMaxArchiveEntries) &&
         std::ranges::all_of(project.painted, [&](int32_t object) {
           return object >= 0 && object < std::ssize(project.objects);
         });
}

}  // namespace

std::string_view FaultOf(const Project& project, const Triangles& triangles) {
  constexpr int64_t kMostNoteBytes = 16 << 10;
  if (!HasGoodCounts(project)) return "impossible counts";
  if (!IsName(project.application) || project.dialect > SettingsDialect::kOrca ||
      !AreSettings(project.settings))
    return "settings that cannot be";
  for (const SceneObject& object : project.objects)
    if (const std::string_view fault = FaultOf(object, triangles); !fault.empty()) return fault;
  for (const ProjectPlate& plate : project.plates)
    if (!IsPlate(plate, project)) return "a plate that cannot be";
  const bool good_notes =
      std::all_of(project.without_effect.begin(), project.without_effect.end(),
                  [](const std::string& note) { return IsText(note, kMostNoteBytes); });
  return good_notes ? "" : "notes that are no text";
}

}  // namespace slicefarm::slicing
