#pragma once

#include "common/model/scene/mesh.h"
#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {

/// Pairs the half-edges of fans: edges with more than two faces, for example where two cubes touch.
///
/// Around such an edge, sorted by angle, each face is either the first or the last side of a wedge
/// of solid material. The two faces of a wedge are paired; nested wedges are paired like brackets.
/// If one face ends a wedge and another face at the same angle begins the next one, the wedges stay
/// separate. So bodies that only touch along an edge stay separate bodies, and every loop that
/// crosses the edge closes. If the number of faces is odd, one half-edge gets no twin.
///
/// The angles are compared by exact determinants, and equal faces are interchangeable, so the order
/// of the triangles does not matter. Cost: O(k log k) for k half-edges on the edge.
void PairFans(const IndexedMesh& mesh, EdgeTable& table);

}  // namespace slicefarm::slicing
