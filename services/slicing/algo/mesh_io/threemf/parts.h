#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/components.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Package and settings from which the parts of objects are made.
struct PartsSource {
  const Package& package;
  const ComponentTree& tree;
  const ModelSettings& settings;
};

/// Returns the parts of an object: its meshes, or, if PrusaSlicer wrote volumes, ranges of its
/// mesh's triangles. Painted seams and supports are added as enforcers and blockers.
///
/// `name`: the object's name, for notes on settings without effect. Errors: any error of
/// ComponentTree::Flatten; MESH_MALFORMED for ranges that are beyond the mesh or overlap.
absl::StatusOr<std::vector<Part>> PartsOf(const PartsSource& source, const ObjectKey& key,
                                          std::string_view name, Notes& notes);

/// Returns true if filaments are painted on a mesh of the object. Errors: any error of
/// ComponentTree::Flatten.
absl::StatusOr<bool> HasPaintedFilaments(const PartsSource& source, const ObjectKey& key);

}  // namespace slicefarm::slicing::threemf
