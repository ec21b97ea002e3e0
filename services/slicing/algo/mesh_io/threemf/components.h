#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/threemf/package.h"

namespace slicefarm::slicing::threemf {

/// A mesh of an object that is made of components, and how it lies in it.
struct FlatPart {
  ObjectKey mesh_object;
  Transform to_object = Transform::Identity();
  /// Of the object's components, the one that the mesh came by; the object's own id if the mesh is
  /// its own.
  ResourceId component = 0;
};

/// Whose components are what: every use of an object in the package, resolved and checked once.
class ComponentTree {
 public:
  /// Keeps the package. Errors, with a place: MESH_MALFORMED for an object that is not there, for
  /// objects that contain themselves, and for more than limits::kMaxComponentsDepth levels.
  static absl::StatusOr<ComponentTree> Make(const Package& package);

  /// The meshes of an object, in the order of the file.
  /// Errors: MESH_TOO_LARGE beyond limits::kMaxParts; those of CheckTransform for what transforms
  /// come to together.
  absl::StatusOr<std::vector<FlatPart>> Flatten(const ObjectKey& key) const;

  /// The object that `key` is but another name of: one whose only component is not moved and lies
  /// in the same file, over and over; else itself.
  ObjectKey Original(ObjectKey key) const;

 private:
  struct Node {
    struct Use {
      ObjectKey object;
      size_t index = 0;  ///< of ObjectResource::components
    };
    std::vector<Use> components;  ///< those that have meshes
    int64_t meshes = 0;           ///< of all levels; no more than limits::kMaxParts + 1
    int64_t height = -1;
    bool entered = false;
  };
  explicit ComponentTree(const Package& package) : package_(&package) {}

  const Node& At(const ObjectKey& key) const { return nodes_[key.file][key.object]; }
  absl::Status Visit(const ObjectKey& key, int64_t depth);
  absl::Status Append(const ObjectKey& key, const FlatPart& from,
                      std::vector<FlatPart>& parts) const;

  const Package* package_;
  std::vector<std::vector<Node>> nodes_;  ///< as Package::files and their objects
};

}  // namespace slicefarm::slicing::threemf
