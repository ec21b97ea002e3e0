#include "services/slicing/algo/mesh_io/threemf/project.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/beds.h"
#include "services/slicing/algo/mesh_io/threemf/components.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/parts.h"
#include "services/slicing/algo/mesh_io/threemf/plates.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

namespace slicefarm::slicing::threemf {
namespace {

int64_t TextBytes(const std::vector<Setting>& settings) {
  int64_t bytes = 0;
  for (const Setting& setting : settings)
    bytes += static_cast<int64_t>(setting.key.size() + setting.value.size());
  return bytes;
}

class ProjectBuilder {
 public:
  ProjectBuilder(const Package& package, const ComponentTree& tree, Metadata metadata)
      : package_(package), tree_(tree), metadata_(std::move(metadata)) {}

  absl::StatusOr<Project> Run() && {
    project_.application = package_.files.front().application;
    project_.dialect = metadata_.dialect;
    project_.settings = std::move(metadata_.project.settings);
    if (metadata_.project.has_scripts || metadata_.model.has_scripts)
      notes_.Add("scripts (post_process), which are never run", {});
    for (const BuildItem& item : package_.files.front().items)
      if (absl::Status status = Add(item); !status.ok()) return status;
    if (project_.objects.empty())
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                       "the file has nothing to build");
    if (!metadata_.has_printer && HasPlaces(package_.files.front().items))
      notes_.Add("positions on the bed (the file has no printer settings)", {});
    AddBeds(metadata_.beds, project_, notes_);
    AddPlates(metadata_.model.plates, items_, project_, notes_);
    project_.without_effect = notes_.Lines();
    if (absl::Status status = CheckTextBytes(); !status.ok()) return status;
    return std::move(project_);
  }

 private:
  /// Returns true if there are several items and a user placed at least one of them.
  static bool HasPlaces(const std::vector<BuildItem>& items) {
    return items.size() > 1 && std::ranges::any_of(items, [](const BuildItem& item) {
             return item.transform(0, 3) != 0 || item.transform(1, 3) != 0;
           });
  }

  absl::Status Add(const BuildItem& item) {
    absl::StatusOr<ObjectKey> key = package_.Resolve(item, 0);
    if (!key.ok()) return key.status();
    if (metadata_.dialect == SettingsDialect::kPrusa) *key = tree_.Original(*key);
    const ObjectResource& resource = package_.At(*key);
    if (resource.type != "model") {
      notes_.Add(fmt::format("objects of type `{}`", resource.type), NameOf(*key));
      return absl::OkStatus();
    }
    const absl::StatusOr<size_t> object = IndexOf(*key, item.line);
    if (!object.ok()) return object.status();
    std::vector<Instance>& instances = project_.objects[*object].instances;
    if (package_.IsNamedByNumber(*key))
      items_[item.object].push_back(
          {static_cast<int32_t>(*object), static_cast<int32_t>(instances.size())});
    instances.push_back({item.transform, item.printable, metadata_.has_printer});
    return absl::OkStatus();
  }

  /// Returns the settings of an object, or nullptr if it has none.
  const ObjectSettings* SettingsOf(const ObjectKey& key) const {
    return package_.IsNamedByNumber(key) ? metadata_.model.Of(package_.At(key).id) : nullptr;
  }

  std::string NameOf(const ObjectKey& key) const {
    const ObjectResource& resource = package_.At(key);
    const ObjectSettings* settings = SettingsOf(key);
    if (settings != nullptr && !settings->name.empty()) return settings->name;
    return resource.name.empty() ? fmt::format("object {}", resource.id) : resource.name;
  }

  /// Returns the index of the object in the project. Creates the object on the first call.
  absl::StatusOr<size_t> IndexOf(const ObjectKey& key, int64_t line) {
    const auto [found, first] = index_.emplace(key, project_.objects.size());
    if (!first) return found->second;
    SceneObject object;
    object.name = NameOf(key);
    absl::StatusOr<std::vector<Part>> parts =
        PartsOf({package_, tree_, metadata_.model}, key, object.name, notes_);
    if (!parts.ok()) return parts.status();
    absl::Status status = Count(*parts, object.name);
    if (!status.ok()) return WithLocation({package_.files.front().part, line}, status);
    object.parts = *std::move(parts);
    if (const ObjectSettings* settings = SettingsOf(key); settings != nullptr)
      object.settings = settings->settings;
    const auto number = static_cast<int64_t>(project_.objects.size()) + 1;
    if (const auto own = metadata_.profiles.find(number); own != metadata_.profiles.end())
      if (absl::Status added = AddSetting("layer_height_profile", own->second, object.settings);
          !added.ok())
        return WithLocation({package_.files.front().part, line}, added);
    const auto ranges = metadata_.ranges.find(number);
    if (ranges != metadata_.ranges.end()) object.ranges = std::move(ranges->second);
    const auto painted = HasPaintedFilaments({package_, tree_, metadata_.model}, key);
    if (!painted.ok()) return painted.status();
    if (*painted) project_.painted.push_back(static_cast<int32_t>(project_.objects.size()));
    project_.objects.push_back(std::move(object));
    return found->second;
  }

  absl::Status Count(const std::vector<Part>& parts, std::string_view name) {
    if (parts.empty())
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                       fmt::format("`{}` has no triangles", name));
    parts_ += static_cast<int64_t>(parts.size());
    if (parts_ > limits::kMaxParts)
      return LimitError(Reason::kMeshTooLarge, "parts of all objects", limits::kMaxParts, parts_);
    for (const Part& part : parts) triangles_ += TrianglesOf(part.mesh);
    if (triangles_ > limits::kMaxTriangles)
      return LimitError(Reason::kMeshTooLarge, "triangles of all parts", limits::kMaxTriangles,
                        triangles_);
    return absl::OkStatus();
  }

  int64_t TrianglesOf(const MeshRef& ref) {
    if (ref.triangle_count >= 0) return ref.triangle_count;
    if (triangles_of_mesh_.empty()) {
      for (const ModelFile& file : package_.files) {
        for (const ObjectResource& object : file.objects)
          if (object.mesh >= 0) triangles_of_mesh_[object.mesh] = object.triangles;
      }
    }
    return triangles_of_mesh_[ref.mesh];
  }

  absl::Status CheckTextBytes() const {
    int64_t bytes = TextBytes(project_.settings);
    for (const SceneObject& object : project_.objects) {
      bytes += TextBytes(object.settings);
      for (const Part& part : object.parts) bytes += TextBytes(part.settings);
      for (const HeightRange& range : object.ranges) bytes += TextBytes(range.settings);
    }
    for (const ProjectPlate& plate : project_.plates) bytes += TextBytes(plate.settings);
    return bytes <= limits::kMaxProjectBytes
               ? absl::OkStatus()
               : LimitError(Reason::kMeshTooLarge, "bytes of all settings in the file",
                            limits::kMaxProjectBytes, bytes);
  }

  const Package& package_;
  const ComponentTree& tree_;
  Metadata metadata_;
  Project project_;
  Notes notes_;
  std::map<ObjectKey, size_t> index_;  ///< object key -> index into Project::objects
  ItemsOfObject items_;
  std::map<int32_t, int64_t> triangles_of_mesh_;
  int64_t parts_ = 0;
  int64_t triangles_ = 0;
};

}  // namespace

absl::StatusOr<Project> MakeProject(const Package& package, Metadata metadata) {
  const absl::StatusOr<ComponentTree> tree = ComponentTree::Make(package);
  if (!tree.ok()) return tree.status();
  return ProjectBuilder(package, *tree, std::move(metadata)).Run();
}

}  // namespace slicefarm::slicing::threemf
