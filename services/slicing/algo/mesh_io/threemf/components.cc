#include "services/slicing/algo/mesh_io/threemf/components.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/transform_text.h"

namespace slicefarm::slicing::threemf {

absl::StatusOr<ComponentTree> ComponentTree::Make(const Package& package) {
  ComponentTree tree(package);
  for (const ModelFile& file : package.files) tree.nodes_.emplace_back(file.objects.size());
  for (size_t file = 0; file < package.files.size(); ++file) {
    for (size_t object = 0; object < tree.nodes_[file].size(); ++object)
      if (absl::Status status = tree.Visit({file, object}, 0); !status.ok()) return status;
  }
  return tree;
}

absl::Status ComponentTree::Visit(const ObjectKey& key, int64_t depth) {
  Node& node = nodes_[key.file][key.object];
  if (node.height >= 0) return absl::OkStatus();
  const ObjectResource& object = package_->At(key);
  const FileLocation place = {package_->files[key.file].part, object.line};
  if (node.entered)
    return WithLocation(place, Malformed(fmt::format("object {} contains itself", object.id)));
  node.entered = true;
  node.meshes = object.mesh >= 0 ? 1 : 0;
  int64_t height = 0;
  for (size_t i = 0; i < object.components.size(); ++i) {
    const absl::StatusOr<ObjectKey> inner = package_->Resolve(object.components[i], key.file);
    if (!inner.ok()) return inner.status();
    if (depth < limits::kMaxComponentsDepth)
      if (absl::Status status = Visit(*inner, depth + 1); !status.ok()) return status;
    // Objects deeper than the limit were not visited and have no height. They count as one level
    // here, which exceeds the limit.
    height = std::max(height, std::max(At(*inner).height, int64_t{0}) + 1);
    node.meshes = std::min(node.meshes + At(*inner).meshes, limits::kMaxParts + 1);
    if (At(*inner).meshes > 0) node.components.push_back({*inner, i});
  }
  if (depth + height > limits::kMaxComponentsDepth)
    return WithLocation(place, LimitError(Reason::kMeshMalformed, "components within each other",
                                          limits::kMaxComponentsDepth, depth + height));
  node.height = height;
  return absl::OkStatus();
}

absl::StatusOr<std::vector<FlatPart>> ComponentTree::Flatten(const ObjectKey& key) const {
  const ObjectResource& object = package_->At(key);
  if (At(key).meshes > limits::kMaxParts)
    return WithLocation(
        {package_->files[key.file].part, object.line},
        LimitError(Reason::kMeshTooLarge, "parts of an object", limits::kMaxParts, At(key).meshes));
  std::vector<FlatPart> parts;
  FlatPart from;
  from.component = object.id;
  if (object.mesh >= 0) {
    from.mesh_object = key;
    parts.push_back(from);
  }
  for (const Node::Use& use : At(key).components) {
    from.component = object.components[use.index].object;
    from.to_object = object.components[use.index].transform;
    absl::Status status = Append(use.object, from, parts);
    if (!status.ok()) return status;
  }
  return parts;
}

absl::Status ComponentTree::Append(const ObjectKey& key, const FlatPart& from,
                                   std::vector<FlatPart>& parts) const {
  const ObjectResource& object = package_->At(key);
  const std::string& part = package_->files[key.file].part;
  if (object.mesh >= 0) {
    parts.push_back(from);
    parts.back().mesh_object = key;
  }
  for (const Node::Use& use : At(key).components) {
    const ObjectUse& component = object.components[use.index];
    FlatPart inner = from;
    inner.to_object = Composed(from.to_object, component.transform);
    absl::Status status = CheckTransform(inner.to_object);
    if (!status.ok()) return WithLocation({part, component.line}, status);
    status = Append(use.object, inner, parts);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

ObjectKey ComponentTree::Original(ObjectKey key) const {
  for (;;) {
    const std::vector<ObjectUse>& components = package_->At(key).components;
    if (components.size() != 1 || components[0].transform != Transform(Transform::Identity()))
      return key;
    if (At(key).components.empty() || At(key).components[0].object.file != key.file) return key;
    key = At(key).components[0].object;
  }
}

}  // namespace slicefarm::slicing::threemf
