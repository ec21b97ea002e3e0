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

/// Key of an object in a package: index of its model file, and index of the object in that file.
struct ObjectKey {
  size_t file = 0;
  size_t object = 0;

  friend auto operator<=>(const ObjectKey&, const ObjectKey&) = default;
};

/// Model files of an archive. The first file contains the list of build items. The order of the
/// remaining files is the order in which paths to them first appear.
struct Package {
  std::vector<ModelFile> files;
  std::vector<RawMesh> meshes;  ///< meshes of the objects, then meshes of the areas painted on them

  /// Returns the object with this key.
  const ObjectResource& At(const ObjectKey& key) const {
    return files[key.file].objects[key.object];
  }
  /// Slicer settings identify an object only by its id, without the file. Returns true if the id of
  /// such a setting means this object. The object is then in the first file, or its id is not used
  /// in the first file. The second case is for the first projects of Bambu Studio, which build
  /// objects of other files directly.
  bool IsNamedByNumber(const ObjectKey& key) const {
    return key.file == 0 || !files.front().by_id.contains(At(key).id);
  }
  /// Returns the object to which `use`, which is in files[file], refers. Errors: MESH_MALFORMED
  /// with the location in the file.
  absl::StatusOr<ObjectKey> Resolve(const ObjectUse& use, size_t file) const;
};

/// Reads the model files of an archive. Errors: any error of ReadModelFile; MESH_FORMAT_UNKNOWN for
/// an archive that is no 3MF; MESH_MALFORMED for a path to a missing file.
absl::StatusOr<Package> ReadPackage(const Archive& archive, MeshReading reading,
                                    const CancelToken& cancel);

}  // namespace slicefarm::slicing::threemf
