#pragma once

#include <cstdint>

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Flips the faces that are oriented against most faces of their body. Then neighbours traverse
/// their common edge in opposite directions. Updates `table` as well. If an edge cannot be made
/// consistent (a Moebius strip), its half-edges lose their twins. If both orientations have equally
/// many faces, the one that makes the body's volume positive is used. Returns the number of flipped
/// faces. Cost: O(n) for n faces; O(1) if the table has no conflicts.
int64_t OrientFaces(IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
