#pragma once

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Pairs the half-edges of edges with more than two faces, such as where two cubes touch.
///
/// Around an edge, in the order of the angle, faces open and close wedges of solid matter; the two
/// faces of a wedge are paired, nested wedges like brackets. Where one face closes a wedge and
/// another at the same angle opens the next, the wedges stay apart. So bodies that only touch along
/// an edge stay bodies of their own, and every loop that crosses the edge closes. A half-edge
/// without a partner (an odd number of faces) gets no twin.
///
/// The angles are compared by exact determinants, and equal faces are interchangeable: the order of
/// the triangles plays no part. Cost: O(k log k) for k half-edges on the edge.
void PairFans(const IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
