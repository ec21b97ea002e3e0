#pragma once

#include <cstdint>

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Flips the faces that are oriented against most faces of their body, so that neighbours run along
/// their common edge in opposite directions. Updates `table` as well. If this is impossible (a
/// Moebius strip), the edge loses its twins. If both orientations have equally many faces, the one
/// that makes the body's volume positive is used. Returns the number of flipped faces. Cost: O(n)
/// for n faces; nothing to do for a table without conflicts.
int64_t OrientFaces(IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
