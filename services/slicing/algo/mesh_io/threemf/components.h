#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/threemf/package.h"

namespace slicefarm::slicing::threemf {

/// Mesh of an object (its own, or that of a component on any level), and the transform into that
/// object.
struct FlatPart {
  ObjectKey mesh_object;
  Transform to_object = Transform::Identity();
  /// Id of the object's direct component that contains the mesh. Id of the object itself if the
  /// mesh is its own.
  ResourceId component = 0;
};

/// Tree of the components of all objects in a package. Every use of an object is resolved and
/// checked once.
class ComponentTree {
 public:
  /// Builds the tree, which keeps a reference to `package`. Errors, with the location in the file:
  /// MESH_MALFORMED for a missing object, for objects that contain themselves, and for more than
  /// limits::kMaxComponentsDepth levels.
  static absl::StatusOr<ComponentTree> Make(const Package& package);

  /// Returns the meshes of an object, in the order of the file. Errors: MESH_TOO_LARGE beyond
  /// limits::kMaxParts; any error of CheckTransform for the combined transforms.
  absl::StatusOr<std::vector<FlatPart>> Flatten(const ObjectKey& key) const;

  /// Returns the object that `key` is an alias of, or `key` itself if it is no alias. An alias is
  /// an object with one single component, which is not moved and is in the same file. If the
  /// component is an alias too, it is followed.
  ObjectKey Original(ObjectKey key) const;

 private:
  struct Node {
    struct Use {
      ObjectKey object;
      size_t index = 0;  ///< index into ObjectResource::components
    };
    std::vector<Use> components;  ///< components that contain meshes
    int64_t meshes = 0;           ///< meshes on all levels, at most limits::kMaxParts + 1
    int64_t height = -1;
    bool entered = false;
  };
  explicit ComponentTree(const Package& package) : package_(&package) {}

  const Node& At(const ObjectKey& key) const { return nodes_[key.file][key.object]; }
  absl::Status Visit(const ObjectKey& key, int64_t depth);
  absl::Status Append(const ObjectKey& key, const FlatPart& from,
                      std::vector<FlatPart>& parts) const;

  const Package* package_;
  std::vector<std::vector<Node>> nodes_;  ///< nodes per file and object, as in Package::files
};

}  // namespace slicefarm::slicing::threemf
