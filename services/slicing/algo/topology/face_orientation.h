#pragma once

#include <cstdint>

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Turns the faces of each body that run against its majority, so that neighbours over an edge of
/// two faces run along it in opposite directions; `table` follows. Where that cannot be (a Moebius
/// strip) the edge loses its twins. Of two equal halves, the one that leaves the body's volume
/// positive stays. Returns how many faces were turned. Cost: O(n); nothing to do for a table
/// without conflicts.
int64_t OrientFaces(IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
