#pragma once

#include <cstdint>

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Turns the faces of each body that run against its majority, so that neighbours run along their
/// common edge in opposite directions. Updates `table` as well. If this is impossible (a Moebius
/// strip), the edge loses its twins. With two equal halves, the one that makes the body's volume
/// positive stays. Returns the number of turned faces. Cost: O(n); nothing to do for a table
/// without conflicts.
int64_t OrientFaces(IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
