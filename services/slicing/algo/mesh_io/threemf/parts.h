#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/components.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// What the parts of one object are made from.
struct PartsSource {
  const Package& package;
  const ComponentTree& tree;
  const ModelSettings& settings;
};

/// The parts of an object: its meshes, or, if PrusaSlicer says so, ranges of its mesh's triangles;
/// and the seams and supports that are painted on them, as enforcers and blockers.
/// `name`: the object's, for notes on what has no effect. Errors: those of Flatten; MESH_MALFORMED
/// for ranges beyond the mesh or over each other.
absl::StatusOr<std::vector<Part>> PartsOf(const PartsSource& source, const ObjectKey& key,
                                          std::string_view name, Notes& notes);

/// Returns true if filaments are painted on a mesh of the object. Errors: those of Flatten.
absl::StatusOr<bool> HasPaintedFilaments(const PartsSource& source, const ObjectKey& key);

}  // namespace slicefarm::slicing::threemf
