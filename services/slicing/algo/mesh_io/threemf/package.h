#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"
#include "services/slicing/algo/mesh_io/threemf/model_file.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive.h"

namespace slicefarm::slicing::threemf {

/// An object of a package: the index of its model file, and its own there.
struct ObjectKey {
  size_t file = 0;
  size_t object = 0;

  friend auto operator<=>(const ObjectKey&, const ObjectKey&) = default;
};

/// The model files of an archive: the first is the one that says what to build, the others come in
/// the order in which they are first named.
struct Package {
  std::vector<ModelFile> files;
  std::vector<RawMesh> meshes;  ///< of the objects, then of the areas painted on them

  const ObjectResource& At(const ObjectKey& key) const {
    return files[key.file].objects[key.object];
  }
  /// Whether settings that name an object by its number alone mean this one: one of the first file,
  /// or, as Bambu Studio's first projects are, of another that is built without being in the first.
  bool IsNamedByNumber(const ObjectKey& key) const {
    return key.file == 0 || !files.front().by_id.contains(At(key).id);
  }
  /// The object that `use` names in files[file]. Errors: MESH_MALFORMED with a place.
  absl::StatusOr<ObjectKey> Resolve(const ObjectUse& use, size_t file) const;
};

/// Errors: those of ReadModelFile; MESH_FORMAT_UNKNOWN for an archive that is no 3MF;
/// MESH_MALFORMED for a path to a file that is not there.
absl::StatusOr<Package> ReadPackage(const Archive& archive, MeshReading reading,
                                    const CancelToken& cancel);

}  // namespace slicefarm::slicing::threemf
